#include "cli/commands/all_commands.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/elastic_table.h"
#include "cli/listing.h"
#include "cli/number_bounds.h"
#include "cli/system_options.h"
#include "viscera/coordinates/measure/system_properties.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/deformation/tetrahedralise.h"
#include "viscera/thesis/measured_scenes.h"

namespace viscera::app::cli {
namespace {

using coordinates::SceneProperties;
using coordinates::SystemProperties;
using nlohmann::ordered_json;

/// A turn changes less than that by rounding alone; the sampled systems' sums are the least exact.
constexpr double kRotationInvariant = 1e-6;

template <class Number>
ordered_json numberOrNull(const std::optional<Number>& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

bool interpolates(const SceneProperties& scene) {
  return scene.handleGaps == 0 && scene.handleError < coordinates::kInterpolated;
}

/// Adds the measurements of one scene, or of the worst of all.
void addNumbers(ordered_json& row, const SceneProperties& scene) {
  row["identityError"] = scene.identityError;
  row["unityError"] = scene.unityError;
  row["minWeight"] = scene.minWeight;
  row["largestJump"] = numberOrNull(scene.jump);
  row["kinks"] = numberOrNull(scene.kinks);
  row["largestKink"] = scene.largestKink;
  row["localMaxima"] = numberOrNull(scene.maxima);
  row["rotationChange"] = scene.rotationChange;
  row["rotationInvariant"] = scene.rotationChange < kRotationInvariant;
  row["handleError"] = scene.handleError;
  row["handleGaps"] = scene.handleGaps;
  row["interpolates"] = interpolates(scene);
  row["nsPerVertexHandle"] = scene.nanoseconds;
  row["points"] = scene.points;
  row["failures"] = scene.failures;
}

std::string optionalText(const std::optional<double>& value) {
  return value ? significant(*value, 2) : "-";
}

std::string optionalText(const std::optional<int>& value) {
  return value ? std::to_string(*value) : "-";
}

/// A quoted cell of CSV.
std::string quoted(const std::string& text) {
  std::string cell = "\"";
  for (const char letter : text)
    cell += letter == '"' ? "\"\"" : std::string(1, letter == '\n' ? ' ' : letter);
  return cell + "\"";
}

struct Column {
  const char* title;
  std::function<std::string(const SystemProperties&, const SceneProperties& worst)> text;
};

std::vector<Column> columns() {
  const auto of = [](double SceneProperties::*member) {
    return [member](const SystemProperties&, const SceneProperties& worst) {
      return significant(worst.*member, 2);
    };
  };
  return {{"system", [](const auto& system, const auto&) { return system.id; }},
          {"identity", of(&SceneProperties::identityError)},
          {"unity", of(&SceneProperties::unityError)},
          {"least", of(&SceneProperties::minWeight)},
          {"jump", [](const auto&, const auto& worst) { return optionalText(worst.jump); }},
          {"kinks", [](const auto&, const auto& worst) { return optionalText(worst.kinks); }},
          {"maxima", [](const auto&, const auto& worst) { return optionalText(worst.maxima); }},
          {"turn", of(&SceneProperties::rotationChange)},
          {"at handles",
           [](const auto&, const auto& worst) {
             return interpolates(worst) ? significant(worst.handleError, 2) : std::string("no");
           }},
          {"ns", of(&SceneProperties::nanoseconds)},
          {"failures", [](const auto& system, const auto& worst) {
             const auto refused = system.refusals();
             return std::to_string(worst.failures) +
                    (refused > 0 ? ", " + std::to_string(refused) + " refused" : "");
           }}};
}

/// "12 points of line, 26 handles", "cloud: needs groups"; one sentence for each scene with failures.
std::vector<std::string> failureReasons(const SystemProperties& system) {
  std::vector<std::string> reasons;
  for (const SceneProperties& scene : system.scenes) {
    if (!scene.refusal.empty())
      reasons.push_back(scene.scene + ": refused, " + scene.refusal);
    else if (scene.failures > 0)
      reasons.push_back(scene.scene + ": no coordinates at " + std::to_string(scene.failures) + " of " +
                        std::to_string(scene.points) + " points");
    for (const std::string& note : scene.notes)
      reasons.push_back(scene.scene + ": " + note);
  }
  return reasons;
}

/// One object a system, with one for each of its scenes in `scenes`.
ordered_json propertiesJson(const SystemProperties& system) {
  ordered_json row = {{"system", system.id}, {"name", system.name}};
  addNumbers(row, system.worst());
  row["refusals"] = system.refusals();
  row["failureReasons"] = failureReasons(system);
  row["scenes"] = ordered_json::array();
  for (const SceneProperties& scene : system.scenes) {
    ordered_json one = {{"scene", scene.scene}, {"handles", scene.handles}};
    if (scene.refusal.empty())
      addNumbers(one, scene);
    else
      one["refusal"] = scene.refusal;
    row["scenes"].push_back(one);
  }
  return row;
}

/// A header, then one line a system and scene.
std::string propertiesCsv(const std::vector<SystemProperties>& systems) {
  std::string text = "system,scene,handles,points,identity_error,unity_error,min_weight,largest_jump,kinks,"
                     "largest_kink_per_mm,local_maxima,rotation_change,handle_error,handle_gaps,failures,"
                     "ns_per_vertex_handle,refusal\n";
  for (const SystemProperties& system : systems)
    for (const SceneProperties& scene : system.scenes) {
      text += system.id + "," + quoted(scene.scene) + "," + std::to_string(scene.handles) + "," +
              std::to_string(scene.points);
      if (!scene.refusal.empty()) {
        text += ",,,,,,,,,,,,," + quoted(scene.refusal) + "\n";
        continue;
      }
      const auto add = [&](const std::string& cell) { text += "," + cell; };
      add(significant(scene.identityError));
      add(significant(scene.unityError));
      add(significant(scene.minWeight, 6));
      add(scene.jump ? significant(*scene.jump, 6) : "");
      add(scene.kinks ? std::to_string(*scene.kinks) : "");
      add(scene.kinks ? significant(scene.largestKink, 6) : "");
      add(scene.maxima ? std::to_string(*scene.maxima) : "");
      add(significant(scene.rotationChange));
      add(significant(scene.handleError));
      add(std::to_string(scene.handleGaps));
      add(std::to_string(scene.failures));
      add(significant(scene.nanoseconds));
      text += ",\n";
    }
  return text;
}

/// Columns for a reader: one line a system, the worst of its scenes; then why points have no coordinates.
std::string propertiesText(const std::vector<SystemProperties>& systems) {
  const std::vector<Column> all = columns();
  std::vector<std::vector<std::string>> rows(1);
  for (const Column& column : all)
    rows[0].emplace_back(column.title);
  for (const SystemProperties& system : systems) {
    const SceneProperties worst = system.worst();
    auto& row = rows.emplace_back();
    for (const Column& column : all)
      row.push_back(column.text(system, worst));
  }
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      std::size_t width = 0;
      for (const auto& other : rows)
        width = std::max(width, other[i].size());
      text += (i == 0 ? "" : "  ") + row[i];
      if (i + 1 < row.size())
        text += std::string(width - row[i].size(), ' ');
    }
    text += "\n";
  }
  for (const SystemProperties& system : systems)
    for (const std::string& reason : failureReasons(system))
      text += system.id + ", " + reason + "\n";
  return text + "Each number is the worst over the scenes; identity is a part of the handles' size, turn the "
                "largest change by turning everything, at handles the error there, ns of one thread per "
                "vertex and handle; - is not measured (kinks where there is a jump).\n";
}

constexpr int kMostPoints = 100'000;
constexpr int kOrganHandles = 24; ///< Before those that grouping adds.
constexpr auto kOrgan = "liver";

std::vector<coordinates::Scene> scenesFor(int points, CommandContext& context) {
  std::vector<coordinates::Scene> scenes;
  for (const int handles : thesis::kLineHandles)
    scenes.push_back(thesis::lineScene(handles));
  scenes.push_back(coordinates::cloudScene(points));
  context.progress.report(0, "organ");
  Progress quiet;
  scenes.push_back(thesis::organScene(kOrgan, kOrganHandles, points, context.samples, quiet));
  return scenes;
}

/// `viscera properties`: every coordinate system measured side by side.
class PropertiesCommand final : public Command {
public:
  std::string name() const override { return "properties"; }
  std::string summary() const override { return "Measure the properties of the coordinate systems"; }
  std::vector<OutputOption> outputs() const override {
    return {tableOutput("--output"), {"--figure", {".svg"}}};
  }

  void addOptions(CLI::App& options) override {
    options.add_option("--systems", systems_, "Only these systems; 'viscera systems' lists them")
        ->type_name("ID");
    options
        .add_option("--param", parameters_, "A parameter, for every system that takes it; may be repeated")
        ->type_name("NAME=VALUE")
        ->expected(1)
        ->take_all();
    options.add_option("-o,--output", output_, "Table with one row a system and scene (.csv)")
        ->type_name("FILE");
    options.add_option("--points", points_, "Points in the cloud and on the organ")
        ->type_name("N")
        ->check(wholeBetween(10, kMostPoints))
        ->capture_default_str();
    elastic_.addTo(options);
  }

  Outcome run(CommandContext& context) override {
    std::vector<std::shared_ptr<const coordinates::CoordinateSystem>> systems;
    for (const std::string& id : systems_)
      systems.push_back(context.systems.find(id));
    if (systems.empty())
      for (const coordinates::Registry::Entry& entry : context.systems.list())
        systems.push_back(entry.system);
    const auto variants = variantsOf(systems, parameters_);
    if (elastic_.asked())
      return elastic_.run(variants, output_, context);
    const auto scenes = scenesFor(points_, context);
    const auto measured = coordinates::measureSystems(
        variants, scenes, context.threads, deformation::withTetgen({}).tetrahedralise, context.progress);
    context.progress.throwIfCancelled();
    if (!output_.empty())
      writeAtomically(output_, [&](std::ostream& out) { out << propertiesCsv(measured); });

    Outcome outcome;
    outcome.json["rows"] = ordered_json::array();
    for (const SystemProperties& system : measured)
      outcome.json["rows"].push_back(propertiesJson(system));
    outcome.text = propertiesText(measured);
    if (!output_.empty()) {
      outcome.json["file"] = output_;
      outcome.text += "file  " + output_ + "\n";
    }
    return outcome;
  }

private:
  std::vector<std::string> systems_;
  std::vector<std::string> parameters_;
  std::string output_;
  int points_ = 400;
  ElasticTable elastic_;
};

} // namespace

std::unique_ptr<Command> propertiesCommand() {
  return std::make_unique<PropertiesCommand>();
}

} // namespace viscera::app::cli
