#include <cmath>

#include <CLI/CLI.hpp>

#include "cli/commands/all_commands.h"
#include "cli/listing.h"
#include "cli/number_bounds.h"
#include "viscera/core/text.h"
#include "viscera/live/taught_quantities.h"

namespace viscera::app::cli {
namespace {

using live::TaughtQuantity;
using nlohmann::ordered_json;

ordered_json bound(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json();
}

ordered_json diseasesOf(const anatomy::Norm& norm) {
  ordered_json all = ordered_json::array();
  for (const anatomy::DiseaseLimit& limit : norm.disease)
    all.push_back(
        {{"name", limit.name}, {limit.above ? "from" : "upTo", limit.bound}, {"source", limit.source}});
  return all;
}

ordered_json jsonOf(const TaughtQuantity& row, const anatomy::Range& range) {
  return {{"id", row.norm->id},
          {"where", row.where},
          {"here", row.here},
          {"unit", row.norm->unit},
          {"low", bound(range.low)},
          {"high", bound(range.high)},
          {"within", range.holds(row.here)},
          {"remark", row.remark},
          {"source", row.norm->source},
          {"disease", diseasesOf(*row.norm)}};
}

/// `viscera reference`: compares the program's numbers with those of healthy adults.
class ReferenceCommand final : public Command {
public:
  std::string name() const override { return "reference"; }
  std::string summary() const override {
    return "Measure what the program teaches, beside what healthy adults have";
  }

  void addOptions(CLI::App& options) override {
    options.add_option("--sex", sex_, "Whose ranges")
        ->check(CLI::IsMember({"either", "women", "men"}))
        ->capture_default_str();
    options.add_option("--body-surface", surfaceM2_, "Ranges of a person of that body surface, m2")
        ->type_name("M2")
        ->check(between(anatomy::kSmallestBodySurfaceM2, anatomy::kLargestBodySurfaceM2));
    options.add_flag("--markdown", markdown_, "As a table in Markdown, as in docs/reference_values.md");
  }

  Outcome run(CommandContext& context) override {
    const anatomy::Person person{anatomy::sexFromId(sex_), surfaceM2_};
    const std::vector<TaughtQuantity> rows =
        live::taughtQuantities(context.samples, context.progress, context.threads);
    Outcome outcome;
    outcome.json = {{"sex", sex_}, {"bodySurfaceM2", surfaceM2_}, {"rows", ordered_json::array()}};
    Listing listing;
    for (const TaughtQuantity& row : rows) {
      const anatomy::Range range = anatomy::rangeOf(*row.norm, person);
      outcome.json["rows"].push_back(jsonOf(row, range));
      listing.add(row.norm->subject + ", " + row.norm->quantity,
                  significant(row.here, 3) + " " + row.norm->unit + " (" + row.where + "); healthy adults " +
                      live::rangeText(range) + " (" + row.norm->source + ")");
      for (const anatomy::DiseaseLimit& limit : row.norm->disease)
        listing.add("", limit.name + (limit.above ? " from " : " up to ") + significant(limit.bound, 3) +
                            " " + row.norm->unit + " (" + limit.source + ")");
    }
    outcome.text = markdown_ ? live::markdownTable(rows, person) : listing.text();
    return outcome;
  }

private:
  std::string sex_ = "either";
  double surfaceM2_ = 0;
  bool markdown_ = false;
};

} // namespace

std::unique_ptr<Command> referenceCommand() {
  return std::make_unique<ReferenceCommand>();
}

} // namespace viscera::app::cli
