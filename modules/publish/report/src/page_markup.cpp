#include "page_markup.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace viscera::report {
namespace {

constexpr double kGapMm = 3; ///< Between pictures in a row.

std::string hex(const Vec3& color) {
  char text[8];
  const auto byte = [](double part) {
    return static_cast<int>(std::lround(255 * std::clamp(part, 0.0, 1.0)));
  };
  std::snprintf(text, sizeof text, "#%02x%02x%02x", byte(color[0]), byte(color[1]), byte(color[2]));
  return text;
}

/// Writes the blocks of a report one after the other.
class Markup {
public:
  Markup(const PictureSource& pictures, double pixelsPerMm) : source_(pictures), pixelsPerMm_(pixelsPerMm) {}

  void heading(int level, const std::string& text) {
    const std::string tag = "h" + std::to_string(level);
    text_ += '<' + tag + '>' + escaped(text) + "</" + tag + ">\n";
  }
  void paragraph(const char* kind, const std::string& text) {
    text_ += std::string("<p class=\"") + kind + "\">" + escaped(text) + "</p>\n";
  }
  void operator()(const Paragraph& block) { paragraph("text", block.text); }
  void operator()(const Table& block);
  void operator()(const PictureGrid& block);

  std::string take() { return std::move(text_); }

private:
  void cell(const char* tag, const std::string& markup, bool number) {
    text_ += std::string("<") + tag + (number ? " align=\"right\">" : " align=\"left\">") + markup + "</" +
             tag + '>';
  }
  std::string picture(const Picture& picture, double widthMm, double widthToHeight);

  const PictureSource& source_;
  double pixelsPerMm_;
  std::size_t pictures_ = 0;
  std::string text_;
};

void Markup::operator()(const Table& block) {
  const bool facts = block.head.empty();
  text_ += facts ? "<table class=\"facts\" cellspacing=\"0\" cellpadding=\"2\">\n"
                 : "<table class=\"numbers\" width=\"100%\" cellspacing=\"0\" cellpadding=\"3\">\n";
  if (!facts) {
    text_ += "<thead><tr>";
    for (std::size_t i = 0; i < block.head.size(); ++i)
      cell("th", escaped(block.head[i]), block.numbers[i]);
    text_ += "</tr></thead>\n";
  }
  for (std::size_t row = 0; row < block.rows.size(); ++row) {
    text_ += "<tr>";
    for (std::size_t i = 0; i < block.rows[row].size(); ++i) {
      std::string markup = escaped(block.rows[row][i]);
      if (i == 0 && row < block.swatches.size())
        markup = "<font color=\"" + hex(block.swatches[row]) + "\">&#9632;</font>&nbsp; " + markup;
      if (facts && i == 0)
        text_ += "<td class=\"name\" width=\"22%\">" + markup + "</td>";
      else
        cell("td", markup, block.numbers[i]);
    }
    text_ += "</tr>\n";
  }
  text_ += "</table>\n";
}

std::string Markup::picture(const Picture& picture, double widthMm, double widthToHeight) {
  const auto width = std::lround(widthMm * pixelsPerMm_);
  const auto height = std::lround(widthMm / widthToHeight * pixelsPerMm_);
  std::string markup = "<img src=\"" + source_(pictures_++) + "\" width=\"" + std::to_string(width) +
                       "\" height=\"" + std::to_string(height) + "\" alt=\"" + escaped(picture.caption) +
                       "\">";
  if (!picture.caption.empty())
    markup += "<br><span class=\"caption\">" + escaped(picture.caption) + "</span>";
  return markup;
}

void Markup::operator()(const PictureGrid& block) {
  if (block.columns == 1) {
    for (const Picture& one : block.pictures)
      text_ += "<p class=\"picture\" align=\"center\">" + picture(one, kTextWidthMm, block.widthToHeight) +
               "</p>\n";
    return;
  }
  const double width = (kTextWidthMm - kGapMm * block.columns) / block.columns;
  text_ += "<table class=\"pictures\" width=\"100%\" cellspacing=\"0\" cellpadding=\"2\">\n";
  for (std::size_t i = 0; i < block.pictures.size(); ++i) {
    const bool first = i % static_cast<std::size_t>(block.columns) == 0;
    const bool last =
        i + 1 == block.pictures.size() || (i + 1) % static_cast<std::size_t>(block.columns) == 0;
    text_ += (first ? "<tr>" : std::string()) + "<td align=\"center\">" +
             picture(block.pictures[i], width, block.widthToHeight) + "</td>" + (last ? "</tr>\n" : "");
  }
  text_ += "</table>\n";
}

} // namespace

std::string escaped(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    switch (letter) {
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '&':
      result += "&amp;";
      break;
    case '"':
      result += "&quot;";
      break;
    case '\'':
      result += "&#39;";
      break;
    default:
      if (static_cast<unsigned char>(letter) >= ' ' && letter != '\x7f')
        result += letter;
      else if (letter == '\n' || letter == '\t')
        result += ' ';
    }
  }
  return result;
}

std::string bodyOf(const Report& report, const PictureSource& pictures, double pixelsPerMm) {
  Markup markup(pictures, pixelsPerMm);
  markup.heading(1, report.title);
  markup.paragraph("made", report.made);
  for (const Section& section : report.sections) {
    if (!section.title.empty())
      markup.heading(2, section.title);
    for (const Block& block : section.blocks)
      std::visit(markup, block);
  }
  return markup.take();
}

} // namespace viscera::report
