#include "cli/commands/all_commands.h"

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/listing.h"
#include "viscera/thesis/item.h"
#include "viscera/thesis/result.h"

namespace viscera::app::cli {
namespace {

using nlohmann::ordered_json;
using thesis::Result;

ordered_json jsonOf(const Result& result) {
  const thesis::Verdict verdict = result.verdict();
  ordered_json findings = ordered_json::array(), pictures = ordered_json::array(),
               tables = ordered_json::array();
  for (const thesis::Finding& finding : result.findings)
    findings.push_back(
        {{"criterion", finding.criterion}, {"measured", finding.measured}, {"met", finding.met}});
  for (const thesis::Picture& picture : result.pictures)
    pictures.push_back(picture.name + ".svg");
  for (const thesis::Table& table : result.tables)
    tables.push_back(table.name + ".csv");
  return {{"id", result.id},
          {"title", result.title},
          {"claim", result.claim},
          {"verdict", thesis::nameOf(verdict.judgement)},
          {"because", verdict.because},
          {"findings", findings},
          {"pictures", pictures},
          {"tables", tables},
          {"seconds", result.seconds}};
}

/// `viscera reproduce`: reproduces the thesis's figures and tables.
class ReproduceCommand final : public Command {
public:
  std::string name() const override { return "reproduce"; }
  std::string summary() const override { return "Reproduce the thesis's figures and tables as one page"; }
  std::vector<OutputOption> outputs() const override { return {{"--output"}}; }

  void addOptions(CLI::App& options) override {
    options.add_option("-o,--output", output_, "Folder for index.html, pictures (.svg) and tables (.csv)")
        ->type_name("DIR")
        ->required();
    options.add_option("--only", only_, "Only these, as 4.11 or table-4.1")->type_name("FIGURE");
  }

  Outcome run(CommandContext& context) override {
    const thesis::Bench bench{context.systems, context.samples, context.threads};
    const std::vector<Result> results = thesis::makeAll(thesis::chosenItems(only_), bench, context.progress);
    thesis::writePage(output_, results);
    Outcome outcome;
    outcome.json["figures"] = ordered_json::array();
    outcome.json["tables"] = ordered_json::array();
    Listing listing;
    for (const Result& result : results) {
      outcome.json[result.table ? "tables" : "figures"].push_back(jsonOf(result));
      listing.add(result.label(), result.verdict().text());
    }
    const std::string page = (std::filesystem::path(output_) / "index.html").string();
    outcome.json["page"] = page;
    outcome.text = listing.add("page", page).text();
    return outcome;
  }

private:
  std::string output_;
  std::vector<std::string> only_;
};

} // namespace

std::unique_ptr<Command> reproduceCommand() {
  return std::make_unique<ReproduceCommand>();
}

} // namespace viscera::app::cli
