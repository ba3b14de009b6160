#include "cli/commands/all_commands.h"

#include <optional>

#include <CLI/CLI.hpp>

#include "cli/listing.h"
#include "cli/positions.h"
#include "cli/scan_input.h"
#include "viscera/core/error.h"

namespace viscera::app::cli {
namespace {

using nlohmann::ordered_json;

/// `viscera probe`: values of a scan at places of the patient.
class ProbeCommand final : public Command {
public:
  std::string name() const override { return "probe"; }
  std::string summary() const override { return "Print a scan's values at points"; }

  void addOptions(CLI::App& options) override {
    scan_.addTo(options);
    options.add_option("--at", positions_, "A point in mm, LPS; may be repeated")
        ->type_name("X,Y,Z")
        ->expected(1)
        ->take_all()
        ->required();
  }

  Outcome run(CommandContext& context) override {
    std::vector<Vec3> places;
    for (const std::string& text : positions_)
      places.push_back(positionOf(text, "--at"));
    const medical_io::Scan scan = scan_.read(context.progress);
    Outcome outcome;
    appendFindings(outcome.warnings, scan);
    ordered_json values = ordered_json::array();
    Listing listing;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const std::optional<double> value = scan.at(places[i]);
      values.push_back({{"positionMm", {places[i].x(), places[i].y(), places[i].z()}},
                        {"value", value ? ordered_json(*value) : ordered_json(nullptr)},
                        {"inside", value.has_value()}});
      listing.add(positions_[i], value ? significant(*value, 6) + (scan.unit.empty() ? "" : " " + scan.unit)
                                       : "outside the scan");
    }
    outcome.json = {
        {"file", scan_.file()}, {"unit", scan.unit}, {"values", values}, {"warnings", outcome.warnings}};
    outcome.text = listing.text();
    return outcome;
  }

private:
  ScanInputOptions scan_;
  std::vector<std::string> positions_;
};

} // namespace

std::unique_ptr<Command> probeCommand() {
  return std::make_unique<ProbeCommand>();
}

} // namespace viscera::app::cli
