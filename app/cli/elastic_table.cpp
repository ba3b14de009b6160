#include "cli/elastic_table.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ostream>
#include <utility>

#include <CLI/CLI.hpp>

#include "cli/listing.h"
#include "cli/number_bounds.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/thesis/elastic_chart.h"

namespace viscera::app::cli {
namespace {

using elasticity::DragDifference;
using elasticity::SolvedScene;
using elasticity::SystemDrags;
using elasticity::SystemOnOrgan;
using nlohmann::ordered_json;

ordered_json elasticNumber(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

/// "liver", or "digestive_system/spleen" for one of several surfaces.
elasticity::DragScene sceneOf(const std::string& organ, const elasticity::DragOptions& options,
                              CommandContext& context) {
  const std::size_t slash = organ.find('/');
  Progress quiet;
  constexpr auto resolution = sample_organs::Resolution::low;
  const auto mesh =
      slash == std::string::npos
          ? sample_organs::sampleOrgan(context.samples, organ, resolution, quiet).surfaces.front().mesh
          : sample_organs::sampleSurface(context.samples, organ.substr(0, slash), organ.substr(slash + 1),
                                         resolution, quiet)
                .mesh;
  return elasticity::dragScene(
      organ, *mesh, elasticity::hullAround(mesh->points, options.handles, options.gap), options, quiet);
}

ordered_json organJson(const SolvedScene& solved) {
  ordered_json drags = ordered_json::array();
  double seconds = 0;
  for (const elasticity::ElasticDrag& drag : solved.drags) {
    seconds += drag.seconds;
    ordered_json one = {{"handle", drag.handle}};
    if (drag.refusal.empty())
      one.update(
          {{"dragMm", drag.dragMm}, {"halved", drag.halved}, {"volumeRatioMin", drag.smallestJacobian}});
    else
      one["refusal"] = drag.refusal;
    drags.push_back(one);
  }
  return {
      {"organ", solved.scene.organ},
      {"tetrahedra", solved.scene.elastic->body().mesh().tetrahedra.rows()},
      {"handles", solved.scene.handles.positions.rows()},
      {"points", solved.scene.points.rows()},
      {"witnesses", solved.scene.witnesses.rows()},
      {"solved", solved.solved()},
      {"elasticSecondsPerDrag", seconds / static_cast<double>(std::max<std::size_t>(1, solved.drags.size()))},
      {"drags", drags}};
}

ordered_json differenceJson(const DragDifference& difference) {
  return {{"medianPercentOfDrag", elasticNumber(difference.median)},
          {"p95PercentOfDrag", elasticNumber(difference.p95)},
          {"percentOfElastic", elasticNumber(difference.relative)},
          {"spearman", elasticNumber(difference.spearman)}};
}

ordered_json rowJson(const SystemDrags& system) {
  ordered_json row = {{"system", system.id}, {"name", system.name}, {"drags", system.drags()}};
  row.update(differenceJson(system.middle()));
  row["bindSeconds"] = elasticNumber(system.bindSeconds());
  row["poseMs"] = elasticNumber(system.poseMilliseconds());
  row["organs"] = ordered_json::array();
  for (const SystemOnOrgan& organ : system.organs) {
    ordered_json one = {{"organ", organ.organ}};
    if (!organ.refusal.empty()) {
      one["refusal"] = organ.refusal;
    } else {
      one["bindSeconds"] = organ.bindSeconds;
      one["lostWitnesses"] = organ.lostWitnesses;
      one["drags"] = ordered_json::array();
      for (const DragDifference& drag : organ.drags)
        one["drags"].push_back(differenceJson(drag));
    }
    row["organs"].push_back(one);
  }
  return row;
}

std::string plain(double value) {
  return std::isfinite(value) ? significant(value, 5) : "";
}

/// One line a system, organ and drag; a system that cannot pose an organ has one line with the reason.
std::string elasticCsv(const std::vector<SystemDrags>& systems, const std::vector<SolvedScene>& scenes) {
  std::string text = "system,organ,drag,handle,drag_mm,median_percent_of_drag,p95_percent_of_drag,"
                     "percent_of_elastic,spearman,bind_s,pose_ms,refusal\n";
  for (const SystemDrags& system : systems)
    for (std::size_t s = 0; s < scenes.size(); ++s) {
      const SystemOnOrgan& organ = system.organs[s];
      if (!organ.refusal.empty()) {
        std::string reason;
        for (const char letter : organ.refusal)
          reason += letter == '"' ? "'" : std::string(1, letter == '\n' ? ' ' : letter);
        text += system.id + "," + organ.organ + ",,,,,,,,,,\"" + reason + "\"\n";
        continue;
      }
      std::size_t next = 0;
      for (std::size_t d = 0; d < scenes[s].drags.size(); ++d) {
        const elasticity::ElasticDrag& drag = scenes[s].drags[d];
        if (!drag.refusal.empty())
          continue;
        const DragDifference& found = organ.drags[next++];
        text += system.id + "," + organ.organ + "," + std::to_string(d + 1) + "," +
                std::to_string(drag.handle + 1);
        for (const double value : {drag.dragMm, found.median, found.p95, found.relative, found.spearman,
                                   organ.bindSeconds, organ.poseMilliseconds})
          text += "," + plain(value);
        text += ",\n";
      }
    }
  return text;
}

std::string elasticText(const std::vector<SystemDrags>& systems, const std::vector<SolvedScene>& scenes) {
  const auto cell = [](double value, int digits) {
    return std::isfinite(value) ? fixed(value, digits) : "-";
  };
  std::vector<std::vector<std::string>> rows = {
      {"system", "drags", "median %", "95 % below %", "% of elastic", "Spearman", "bind s", "pose ms"}};
  for (const SystemDrags& system : systems) {
    const DragDifference middle = system.middle();
    rows.push_back({system.id, std::to_string(system.drags()), cell(middle.median, 2), cell(middle.p95, 1),
                    cell(middle.relative, 1), cell(middle.spearman, 2), cell(system.bindSeconds(), 3),
                    cell(system.poseMilliseconds(), 4)});
  }
  std::vector<std::size_t> widths(rows[0].size());
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], row[i].size());
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i)
      text += (i == 0 ? "" : "  ") + row[i] +
              (i + 1 < row.size() ? std::string(widths[i] - row[i].size(), ' ') : std::string());
    text += "\n";
  }
  for (const SystemDrags& system : systems)
    for (const SystemOnOrgan& organ : system.organs)
      if (!organ.refusal.empty())
        text += system.id + ", " + organ.organ + ": " + organ.refusal + "\n";
  for (const SolvedScene& solved : scenes)
    text += solved.scene.organ + ": " +
            std::to_string(solved.scene.elastic->body().mesh().tetrahedra.rows()) + " tetrahedra, " +
            std::to_string(solved.solved()) + " of " + std::to_string(solved.drags.size()) +
            " drags with an equilibrium\n";
  return text;
}

std::string figureOf(const std::vector<SystemDrags>& systems) {
  std::vector<thesis::ElasticRow> rows;
  for (const SystemDrags& system : systems) {
    thesis::ElasticRow row{system.name, {}, {}};
    for (const SystemOnOrgan& organ : system.organs)
      for (const DragDifference& drag : organ.drags) {
        row.relative.push_back(drag.relative);
        row.spearman.push_back(drag.spearman);
      }
    rows.push_back(std::move(row));
  }
  return thesis::elasticChart(rows, "Coordinate systems beside elasticity");
}

} // namespace

void ElasticTable::addTo(CLI::App& options) {
  CLI::Option* asked = options.add_flag("--elasticity", asked_,
                                        "Compare the systems with elastic organs under the same drags");
  options.add_option("--organs", organs_, "Sample organs for --elasticity: NAME or NAME/SURFACE")
      ->type_name("NAME")
      ->needs(asked)
      ->capture_default_str();
  options.add_option("--drags", drags_.drags, "Drags of each organ, for --elasticity")
      ->type_name("N")
      ->needs(asked)
      ->check(wholeBetween(1, 1000))
      ->capture_default_str();
  options
      .add_option("--tetrahedra", drags_.organ.tetrahedra, "About how many tetrahedra an elastic organ has")
      ->type_name("N")
      ->needs(asked)
      ->check(wholeBetween(50, 20'000))
      ->capture_default_str();
  options.add_option("--poisson", drags_.poisson, "Poisson's ratio of an elastic organ")
      ->type_name("NU")
      ->needs(asked)
      ->check(between(0.01, 0.4999))
      ->capture_default_str();
  options.add_option("--figure", figure_, "Picture of the comparison with elasticity (.svg)")
      ->type_name("FILE")
      ->needs(asked);
}

Outcome ElasticTable::run(const std::vector<coordinates::SystemVariant>& variants, const std::string& csv,
                          CommandContext& context) const {
  const auto begin = std::chrono::steady_clock::now();
  std::vector<elasticity::DragScene> scenes;
  for (const std::string& organ : organs_) {
    context.progress.report(0, organ);
    context.progress.throwIfCancelled();
    scenes.push_back(sceneOf(organ, drags_, context));
  }
  std::vector<SolvedScene> solved;
  runPart(context.progress, 0, 0.7, [&](Progress& part) {
    solved = elasticity::solveDrags(std::move(scenes), drags_, context.threads, part);
  });
  std::vector<SystemDrags> systems;
  runPart(context.progress, 0.7, 1, [&](Progress& part) {
    systems = elasticity::compareDrags(variants, solved, context.threads, part);
  });
  context.progress.throwIfCancelled();
  Outcome outcome;
  outcome.text = elasticText(systems, solved);
  outcome.json["poisson"] = drags_.poisson;
  outcome.json["dragFraction"] = drags_.dragFraction;
  outcome.json["organs"] = ordered_json::array();
  for (const SolvedScene& scene : solved)
    outcome.json["organs"].push_back(organJson(scene));
  outcome.json["rows"] = ordered_json::array();
  for (const SystemDrags& system : systems)
    outcome.json["rows"].push_back(rowJson(system));
  if (!csv.empty()) {
    writeAtomically(csv, [&](std::ostream& out) { out << elasticCsv(systems, solved); });
    outcome.json["file"] = csv;
    outcome.text += "file  " + csv + "\n";
  }
  if (!figure_.empty()) {
    writeAtomically(figure_, [&](std::ostream& out) { out << figureOf(systems); });
    outcome.json["figure"] = figure_;
    outcome.text += "figure  " + figure_ + "\n";
  }
  outcome.json["seconds"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return outcome;
}

} // namespace viscera::app::cli
