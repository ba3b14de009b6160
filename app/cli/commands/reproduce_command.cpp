#include "cli/commands/reproduce_command.h"

#include <algorithm>
#include <chrono>

#include <CLI/CLI.hpp>

#include "cli/listing.h"
#include "reproduction/item.h"
#include "reproduction/page.h"
#include "viscera/core/error.h"

namespace viscera::app::cli {
namespace {

using nlohmann::ordered_json;
using reproduction::Item;
using reproduction::Result;

/// Table 4.1 is "table 4.1", so that it is not taken for figure 4.1.
std::string nameOf(const Item& item) {
  return (item.table ? "table-" : "") + item.id;
}

std::vector<Item> chosenItems(const std::vector<std::string>& only) {
  std::vector<Item> all = reproduction::allItems(), chosen;
  std::string known;
  for (const Item& item : all)
    known += (known.empty() ? "" : ", ") + nameOf(item);
  for (const std::string& name : only) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Item& item) { return nameOf(item) == name; });
    if (found == all.end())
      throw UsageError("is no figure that can be done again", name, "there are " + known);
    chosen.push_back(*found);
  }
  return only.empty() ? all : chosen;
}

/// What goes wrong with one figure is said there and stops no other one.
Result made(const Item& item, const Surroundings& surroundings, Progress& progress) {
  Result result;
  result.id = item.id;
  result.table = item.table;
  const auto start = std::chrono::steady_clock::now();
  try {
    item.make(result, surroundings, progress);
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception& error) {
    result.problem = error.what();
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

std::vector<Result> makeAll(const std::vector<Item>& items, const Surroundings& surroundings) {
  std::vector<Result> results;
  Progress& progress = surroundings.progress;
  for (const Item& item : items) {
    progress.throwIfCancelled();
    const double from = static_cast<double>(results.size()), count = static_cast<double>(items.size());
    progress.report(from / count, nameOf(item));
    Progress* running = nullptr;
    Progress part([&](double fraction, const std::string&) {
      // A figure binds many times; its own fraction would run to and fro.
      (void)fraction;
      if (progress.cancelled())
        running->cancel();
    });
    running = &part;
    results.push_back(made(item, surroundings, part));
  }
  progress.throwIfCancelled();
  return results;
}

ordered_json jsonOf(const Result& result) {
  const reproduction::Verdict verdict = result.verdict();
  ordered_json findings = ordered_json::array(), pictures = ordered_json::array(),
               tables = ordered_json::array();
  for (const reproduction::Finding& finding : result.findings)
    findings.push_back(
        {{"criterion", finding.criterion}, {"measured", finding.measured}, {"met", finding.met}});
  for (const reproduction::Picture& picture : result.pictures)
    pictures.push_back(picture.name + ".svg");
  for (const reproduction::Table& table : result.tables)
    tables.push_back(table.name + ".csv");
  return {{"id", result.id},
          {"title", result.title},
          {"claim", result.claim},
          {"verdict", reproduction::nameOf(verdict.judgement)},
          {"because", verdict.because},
          {"findings", findings},
          {"pictures", pictures},
          {"tables", tables},
          {"seconds", result.seconds}};
}

} // namespace

void ReproduceCommand::addOptions(CLI::App& options) {
  options.add_option("-o,--output", output_, "Folder for index.html, pictures (.svg) and tables (.csv)")
      ->type_name("DIR")
      ->required();
  options.add_option("--only", only_, "Only these, as 4.11 or table-4.1")->type_name("FIGURE");
}

Outcome ReproduceCommand::run(Surroundings& surroundings) {
  const std::vector<Result> results = makeAll(chosenItems(only_), surroundings);
  reproduction::writePage(output_, results);
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

} // namespace viscera::app::cli
