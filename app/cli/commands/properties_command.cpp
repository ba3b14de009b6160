#include "cli/commands/properties_command.h"

#include <CLI/CLI.hpp>

#include "cli/properties_table.h"
#include "cli/system_options.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/deformation/tetrahedralise.h"
#include "viscera/reproduction/measured_scenes.h"

namespace viscera::app::cli {
namespace {

constexpr int kMostPoints = 100'000;
constexpr int kOrganHandles = 24; ///< Before those that grouping adds.
constexpr auto kOrgan = "liver";

std::vector<coordinates::Scene> scenesFor(int points, Surroundings& surroundings) {
  std::vector<coordinates::Scene> scenes;
  for (const int handles : reproduction::kLineHandles)
    scenes.push_back(reproduction::lineScene(handles));
  scenes.push_back(coordinates::cloudScene(points));
  surroundings.progress.report(0, "organ");
  Progress quiet;
  scenes.push_back(reproduction::organScene(kOrgan, kOrganHandles, points, surroundings.samples, quiet));
  return scenes;
}

} // namespace

void PropertiesCommand::addOptions(CLI::App& options) {
  options.add_option("--systems", systems_, "Only these systems; 'viscera systems' lists them")
      ->type_name("ID");
  options.add_option("--param", parameters_, "A parameter, for every system that takes it; may be repeated")
      ->type_name("NAME=VALUE")
      ->expected(1)
      ->take_all();
  options.add_option("-o,--output", output_, "Table with one row a system and scene (.csv)")
      ->type_name("FILE");
  options.add_option("--points", points_, "Points in the cloud and on the organ")
      ->type_name("N")
      ->check(CLI::Range(10, kMostPoints))
      ->capture_default_str();
}

Outcome PropertiesCommand::run(Surroundings& surroundings) {
  std::vector<std::shared_ptr<const coordinates::CoordinateSystem>> systems;
  for (const std::string& id : systems_)
    systems.push_back(surroundings.systems.find(id));
  if (systems.empty())
    for (const plugin::Registry::Entry& entry : surroundings.systems.list())
      systems.push_back(entry.system);
  const auto variants = variantsOf(systems, parameters_);
  const auto scenes = scenesFor(points_, surroundings);
  const auto measured =
      coordinates::measureSystems(variants, scenes, surroundings.threads,
                                  deformation::withTetgen({}).tetrahedralise, surroundings.progress);
  surroundings.progress.throwIfCancelled();
  if (!output_.empty())
    writeAtomically(output_, [&](std::ostream& out) { out << propertiesCsv(measured); });

  Outcome outcome;
  outcome.json["rows"] = nlohmann::ordered_json::array();
  for (const coordinates::SystemProperties& system : measured)
    outcome.json["rows"].push_back(propertiesJson(system));
  outcome.text = propertiesText(measured);
  if (!output_.empty()) {
    outcome.json["file"] = output_;
    outcome.text += "file  " + output_ + "\n";
  }
  return outcome;
}

} // namespace viscera::app::cli
