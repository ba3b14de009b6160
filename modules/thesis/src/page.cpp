#include <filesystem>
#include <system_error>

#include "svg_canvas.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/core/text.h"
#include "viscera/thesis/result.h"

namespace viscera::thesis {
namespace {

constexpr auto kStyle = R"(
:root { color-scheme: light; }
body { font: 16px/1.5 'DejaVu Sans', 'Helvetica Neue', Arial, sans-serif; color: #222; background: #fff;
       max-width: 1360px; margin: 0 auto; padding: 1.5rem; }
h1 { font-size: 1.7rem; } h2 { font-size: 1.25rem; margin: 3rem 0 .4rem; border-top: 1px solid #ddd; padding-top: 1rem; }
table { border-collapse: collapse; margin: 1rem 0; font-size: .88rem; }
th, td { border-bottom: 1px solid #ddd; padding: .3rem .7rem; text-align: left; vertical-align: top; }
th { border-bottom: 2px solid #888; }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 560px), 1fr)); gap: 1rem; }
figure { margin: 0; } figure img { width: 100%; height: auto; border: 1px solid #eee; }
figcaption, .setup { color: #555; font-size: .88rem; }
.verdict { font-weight: bold; white-space: nowrap; }
.verdict::before { margin-right: .4em; }
.holds::before { content: '\2713'; } .holds { color: #006b4c; }
.differs::before { content: '\2248'; } .differs { color: #8a5a00; }
.does-not-hold::before { content: '\2717'; } .does-not-hold { color: #a63a00; }
.not-measured::before { content: '\2013'; } .not-measured { color: #555; }
a { color: #0059a0; }
)";

std::string element(const std::string& tag, const std::string& text) {
  return "<" + tag + ">" + escaped(text) + "</" + tag + ">";
}

std::string verdictMark(Judgement judgement) {
  std::string kind = nameOf(judgement);
  for (char& letter : kind)
    letter = letter == ' ' ? '-' : letter;
  return "<span class=\"verdict " + kind + "\">" + nameOf(judgement) + "</span>";
}

std::string linkTo(const std::string& file, const std::string& text) {
  return "<a href=\"" + escaped(file) + "\">" + escaped(text) + "</a>";
}

std::string htmlOf(const Table& table) {
  std::string html = "<table><thead><tr>";
  for (const std::string& cell : table.header)
    html += element("th", cell);
  html += "</tr></thead><tbody>\n";
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (const std::string& cell : row)
      html += element("td", cell);
    html += "</tr>\n";
  }
  return html + "</tbody></table>\n";
}

std::string findingsOf(const Result& result) {
  std::string html =
      "<table><thead><tr><th>the claim takes</th><th>measured</th><th></th></tr></thead><tbody>\n";
  for (const Finding& finding : result.findings)
    html += "<tr>" + element("td", finding.criterion) + element("td", finding.measured) + "<td>" +
            verdictMark(finding.met ? Judgement::holds : Judgement::doesNotHold) + "</td></tr>\n";
  return html + "</tbody></table>\n";
}

std::string sectionOf(const Result& result) {
  const Verdict verdict = result.verdict();
  std::string html =
      "<section id=\"" + result.fileName() + "\">\n" + element("h2", result.label() + ": " + result.title) +
      "\n<p>The thesis: " + escaped(result.claim) + " " + verdictMark(verdict.judgement) + "</p>\n";
  if (!verdict.because.empty())
    html += element("p", "Because " + verdict.because + ".") + "\n";
  html += "<p class=\"setup\">" + escaped(result.setup) + "</p>\n";
  if (!result.findings.empty())
    html += findingsOf(result);
  html += "<div class=\"pictures\">\n";
  for (const Picture& picture : result.pictures)
    html += "<figure><img src=\"" + picture.name + ".svg\" alt=\"" + escaped(picture.caption) +
            "\" loading=\"lazy\">" + element("figcaption", picture.caption) + "</figure>\n";
  html += "</div>\n";
  std::string files;
  for (const Table& table : result.tables) {
    if (table.shown)
      html += htmlOf(table);
    files += (files.empty() ? "Numbers: " : ", ") + linkTo(table.name + ".csv", table.name + ".csv");
  }
  return html + "<p class=\"setup\">" + files + (files.empty() ? "" : "; ") + fixed(result.seconds, 1) +
         " s.</p>\n</section>\n";
}

/// The whole page: a table of all verdicts, then every figure and table with its pictures, what the thesis
/// says, and how that was judged. Takes nothing from outside its folder.
std::string pageOf(const std::vector<Result>& results) {
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n"
      "<title>The thesis, done again</title>\n<style>" +
      std::string(kStyle) + "</style></head><body>\n<h1>The thesis, done again</h1>\n" +
      "<p>Figures and tables of M. \xC3\x80ngels Cerver\xC3\xB3, <i>On Some Interactive Mesh "
      "Deformations</i>, measured with Viscera " VISCERA_VERSION
      ". What the thesis says is in our words. A verdict is computed: a claim holds where every "
      "condition below it is met by the numbers, differs where some are, and does not hold where "
      "none is.</p>\n<table><thead><tr><th></th><th>shows</th><th>the thesis says</th><th>verdict"
      "</th></tr></thead><tbody>\n";
  for (const Result& result : results)
    html += "<tr><td>" + linkTo("#" + result.fileName(), result.label()) + "</td>" +
            element("td", result.title) + element("td", result.claim) + "<td>" +
            verdictMark(result.verdict().judgement) + "</td></tr>\n";
  html += "</tbody></table>\n";
  for (const Result& result : results)
    html += sectionOf(result);
  return html + "</body></html>\n";
}

/// One row of Markdown a figure or table: what it is, and the verdict.
std::string verdictsOf(const std::vector<Result>& results) {
  std::string text = "| in the thesis | shows | verdict |\n|---|---|---|\n";
  for (const Result& result : results)
    text +=
        "| " + result.label() + " | " + result.title + " | " + nameOf(result.verdict().judgement) + " |\n";
  return text;
}

} // namespace

void writePage(const std::filesystem::path& folder, const std::vector<Result>& results) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder, error))
    throw CannotCreateError("the folder cannot be made", folder.string(), "choose another one");
  const auto write = [&](const std::string& name, const std::string& contents) {
    writeAtomically(folder / name, [&](std::ostream& out) { out << contents; });
  };
  for (const Result& result : results) {
    for (const Picture& picture : result.pictures)
      write(picture.name + ".svg", picture.svg);
    for (const Table& table : result.tables)
      write(table.name + ".csv", table.csv());
  }
  write("verdicts.md", verdictsOf(results));
  write("index.html", pageOf(results));
}

} // namespace viscera::thesis
