#include "figures.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include "viscera/coordinates/measure/line_profile.h"
#include "viscera/coordinates/measure/system_properties.h"
#include "viscera/core/text.h"
#include "viscera/deformation/tetrahedralise.h"
#include "viscera/thesis/measured_scenes.h"

namespace viscera::thesis {
namespace {

using coordinates::SceneProperties;

constexpr int kTableHandles = 15;
constexpr Eigen::Index kBoxCorners = 8;
/// A thousandth of a second for 1,000 points is 67 ns; a second for 10,000 vertices and 30 handles this.
constexpr double kEfficientNs = 3300;
constexpr double kInvariant = 1e-9;
constexpr double kExactInTables = 1e-9;
/// Part of all influence that the nearer half of the handles has.
constexpr double kLocal = 0.75;

/// One system, measured along the line.
struct Column {
  std::string id;
  std::string name;
  coordinates::ParameterValues parameters;
  coordinates::Traits traits;
  SceneProperties found;
  double nearHalf = 0;
};

/// The line among its handles; for systems with a cage only the box's corners, which are the cage.
coordinates::Scene sceneFor(const coordinates::Traits& traits) {
  coordinates::Scene scene = lineScene(kTableHandles);
  scene.parts = 200;
  if (traits.needsCage)
    scene.handles.positions = Points(scene.handles.positions.topRows(kBoxCorners));
  return scene;
}

Column measured(const std::string& id, const std::string& name,
                const coordinates::ParameterValues& parameters, const Bench& bench, Progress& progress) {
  const auto system = bench.systems.find(id);
  Column column{id, name, parameters, system->traits(), {}, 0};
  const coordinates::Scene scene = sceneFor(column.traits);
  const auto options = deformation::withTetgen({parameters, Threads{1}, {}});
  column.found = coordinates::measureOn(*system, scene, options, progress);
  if (!column.found.refusal.empty())
    return column;
  const auto profile =
      coordinates::profileAlong(*system, scene.handles, *scene.line, scene.parts, options, progress);
  Points points(scene.parts + 1, 3);
  for (int i = 0; i <= scene.parts; ++i)
    points.row(i) = scene.line->at(static_cast<double>(i) / scene.parts).transpose();
  column.nearHalf = coordinates::nearHalfShare(scene.handles.positions, points, profile.coordinates);
  return column;
}

/// C-, T- and S-Celestial; the first with 1,000 samples, and its time for 100,000.
std::vector<Column> celestialColumns(const Bench& bench, Progress& progress) {
  coordinates::ParameterValues some;
  some.setFromText(bench.systems.find("c-celestial")->parameters(), "samples", "1000");
  std::vector<Column> columns = {measured("c-celestial", "C-Celestial", some, bench, progress),
                                 measured("t-celestial", "T-Celestial", {}, bench, progress),
                                 measured("s-celestial", "S-Celestial", {}, bench, progress)};
  columns[0].found.nanoseconds *= 100;
  return columns;
}

/// One cell: what was measured, and whether that is a yes.
struct Cell {
  bool yes;
  std::string measured;
};

/// One row of a table: a feature, what decides it, and the thesis's marks.
struct Feature {
  std::string name;
  std::string criterion;
  std::function<Cell(const Column&)> measure;
  std::vector<std::optional<bool>> thesis; ///< One a column; nothing where it says neither.
};

Feature rotationInvariant(std::vector<std::optional<bool>> thesis) {
  return {"rotation invariant", "turning everything changes no coordinate by more than 1e-9",
          [](const Column& column) {
            return Cell{column.found.rotationChange < kInvariant,
                        significant(column.found.rotationChange, 2) + " by a turn"};
          },
          std::move(thesis)};
}

Feature interpolating(std::vector<std::optional<bool>> thesis) {
  return {"interpolates its handles", "at a handle its coordinate is 1 to 1e-4, and there is one",
          [](const Column& column) {
            return Cell{column.found.handleGaps == 0 && column.found.handleError < coordinates::kInterpolated,
                        significant(column.found.handleError, 2) + " off at handles" +
                            (column.found.handleGaps > 0
                                 ? ", none at " + std::to_string(column.found.handleGaps)
                                 : "")};
          },
          std::move(thesis)};
}

Feature efficient(std::vector<std::optional<bool>> thesis) {
  return {"efficient", "binds 10,000 vertices to 30 handles within a second: 3,300 ns a vertex and handle",
          [](const Column& column) {
            return Cell{column.found.nanoseconds <= kEfficientNs,
                        significant(column.found.nanoseconds, 3) + " ns a vertex and handle"};
          },
          std::move(thesis)};
}

std::string mark(bool yes) {
  return yes ? "yes" : "no";
}

/// Measures every feature of every column, and makes findings of those that the thesis mentions.
void fill(Result& result, const std::vector<Column>& columns, const std::vector<Feature>& features) {
  Table table{result.fileName(), {"feature"}, {}, true};
  for (const Column& column : columns)
    table.header.push_back(column.name);
  for (const Feature& feature : features) {
    auto& row = table.rows.emplace_back();
    row.push_back(feature.name + " (" + feature.criterion + ")");
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const Column& column = columns[i];
      if (!column.found.refusal.empty()) {
        row.push_back("refused: " + column.found.refusal);
        continue;
      }
      const Cell cell = feature.measure(column);
      row.push_back(mark(cell.yes) + ": " + cell.measured +
                    (feature.thesis[i] ? "; thesis: " + mark(*feature.thesis[i]) : ""));
      if (feature.thesis[i])
        result.findings.push_back({column.name + ": " + (*feature.thesis[i] ? "" : "not ") + feature.name,
                                   cell.measured, cell.yes == *feature.thesis[i]});
    }
  }
  result.tables.push_back(std::move(table));
}

} // namespace

void table41(Result& result, const Bench& bench, Progress& progress) {
  result.title = "What distinguishes the three celestial systems";
  result.claim =
      "C-Celestial is not efficient, T-Celestial depends on rotation, S-Celestial is neither of the two; "
      "all interpolate their handles.";
  result.setup =
      "Measured along the line among 15 handles; C-Celestial with 1,000 samples of its walk, and its time "
      "multiplied by 100 for the 100,000 samples of the thesis.";
  fill(result, celestialColumns(bench, progress),
       {rotationInvariant({true, false, true}), interpolating({true, true, true}),
        efficient({false, true, true})});
}

namespace {

constexpr auto kWeights = "bounded-biharmonic";

/// Mean value, bounded biharmonic where there is such a system, C-, T- and S-Celestial.
std::vector<Column> comparedColumns(const Bench& bench, Progress& progress) {
  std::vector<Column> columns = {measured("mean-value", "mean value", {}, bench, progress)};
  if (bench.systems.contains(kWeights))
    columns.push_back(measured(kWeights, "bounded biharmonic", {}, bench, progress));
  for (Column& column : celestialColumns(bench, progress))
    columns.push_back(std::move(column));
  return columns;
}

/// The thesis's marks for a feature that all have but these.
std::vector<std::optional<bool>> allBut(const std::vector<Column>& columns,
                                        const std::vector<std::string>& ids) {
  std::vector<std::optional<bool>> marks;
  for (const Column& column : columns)
    marks.emplace_back(std::find(ids.begin(), ids.end(), column.id) == ids.end());
  return marks;
}

Cell wellDefined(const Column& column) {
  const SceneProperties& found = column.found;
  return {found.identityError < kExactInTables && found.unityError < kExactInTables &&
              found.minWeight >= -kExactInTables && found.failures == 0,
          "identity " + significant(found.identityError, 2) + ", least " + significant(found.minWeight, 2) +
              ", " + std::to_string(found.failures) + " gaps"};
}

Cell smoothCell(const Column& column) {
  const SceneProperties& found = column.found;
  return {found.kinks && *found.kinks == 0, "jump " + significant(found.jump.value_or(0), 2) + ", " +
                                                (found.kinks ? std::to_string(*found.kinks) : "many") +
                                                " kinks"};
}

Cell local(const Column& column) {
  return {column.nearHalf >= kLocal, significant(column.nearHalf, 2) + " of it"};
}

Cell cageFree(const Column& column) {
  return {!column.traits.needsCage, column.traits.needsCage ? "takes a cage" : "takes handles"};
}

Cell withoutMesh(const Column& column) {
  return {!column.traits.needsTetrahedra, column.traits.needsTetrahedra ? "takes tetrahedra" : "takes none"};
}

} // namespace

void table42(Result& result, const Bench& bench, Progress& progress) {
  result.title = "Celestial systems beside mean value coordinates and bounded biharmonic weights";
  result.claim =
      "All are well-defined, continuous, smooth and local; all but the weights and C-Celestial are "
      "efficient; only mean value coordinates need a cage, only the weights a discretisation.";
  result.setup =
      "Measured along the line among 15 handles, mean value coordinates in the cage of the box's 8 "
      "corners. Handles of several kinds, simplicity and detail are not numbers of a system and not "
      "measured.";
  const std::vector<Column> columns = comparedColumns(bench, progress);
  fill(result, columns,
       {{"well-defined", "identity and unity to 1e-9, nothing negative, no point without coordinates",
         wellDefined, allBut(columns, {})},
        {"continuous and smooth", "neither jump nor kink along the line", smoothCell, allBut(columns, {})},
        {"cage-free", "handles alone are enough", cageFree, allBut(columns, {"mean-value"})},
        efficient(allBut(columns, {kWeights, "c-celestial"})),
        {"needs no discretisation", "no tetrahedra are made first", withoutMesh, allBut(columns, {kWeights})},
        {"local", "the nearer half of the handles have three quarters of all influence", local,
         allBut(columns, {})}});
}

} // namespace viscera::thesis
