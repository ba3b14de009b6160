#include "line_figure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "charts.h"
#include "viscera/core/text.h"
#include "viscera/deformation/tetrahedralise.h"
#include "viscera/thesis/measured_scenes.h"

namespace viscera::thesis {
namespace {

constexpr int kSearchedParts = 400; ///< Before jumps and kinks are looked for more closely.
constexpr int kDrawnParts = 500;
constexpr int kFewDrawnParts = 200; ///< Where a point takes very long.
constexpr int kLongBoxCorners = 8;  ///< The first handles of every table are the corners of a long box.
/// A coordinate below that is negative, and not only rounded.
constexpr double kNegative = -1e-9;
constexpr auto kCornerColor = "#b0b0b0";
constexpr double kPull = 16; ///< mm by which the sketch moves a handle.

coordinates::BindOptions optionsOf(const coordinates::CoordinateSystem& system, const Panel& panel,
                                   Threads threads) {
  coordinates::BindOptions options;
  options.threads = threads;
  for (const auto& [name, value] : panel.choices)
    options.parameters.setFromText(system.parameters(), name, value);
  return deformation::withTetgen(std::move(options));
}

/// The sag that leads the line through a point that sees one inner handle exactly behind another: of all such
/// points the one nearest to the straight line, in its middle part.
Vec3 sagThroughSword(const coordinates::Scene& scene) {
  const Points& handles = scene.handles.positions;
  Vec3 best = Vec3::Zero();
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index near = kLongBoxCorners; near < handles.rows(); ++near)
    for (Eigen::Index far = kLongBoxCorners; far < handles.rows(); ++far) {
      if (near == far)
        continue;
      const Vec3 beyond = (handles.row(near) + 0.35 * (handles.row(near) - handles.row(far))).transpose();
      const double place = (beyond[0] - scene.line->from[0]) / (scene.line->to[0] - scene.line->from[0]);
      if (place < 0.25 || place > 0.75)
        continue;
      const Vec3 sag = Vec3(0, beyond[1], beyond[2]) / (4 * place * (1 - place));
      if (sag.norm() < least) {
        least = sag.norm();
        best = sag;
      }
    }
  return best;
}

coordinates::Scene sceneOf(const Panel& panel) {
  coordinates::Scene scene = lineScene(panel.handles);
  if (panel.sword)
    scene.line->sag = sagThroughSword(scene);
  return scene;
}

int drawnParts(const Panel& panel) {
  return panel.profileOnly ? kFewDrawnParts : kDrawnParts;
}

std::string handleName(Eigen::Index handle) {
  return handle < kLongBoxCorners ? "corner " + std::to_string(handle + 1)
                                  : "handle " + std::to_string(handle + 1 - kLongBoxCorners);
}

Pen penOf(Eigen::Index handle) {
  return handle < kLongBoxCorners ? Pen{kCornerColor, 1.1, {}, 1}
                                  : penFor(static_cast<std::size_t>(handle - kLongBoxCorners));
}

std::vector<double> places(const coordinates::Scene& scene, int parts) {
  std::vector<double> result;
  for (int i = 0; i <= parts; ++i)
    result.push_back(scene.line->at(static_cast<double>(i) / parts)[0]);
  return result;
}

std::string plotOf(const Panel& panel, const coordinates::Scene& scene, const PanelResult& result) {
  const Eigen::MatrixXd values = coordinatesWithGaps(result);
  CurveChart chart;
  chart.title = panel.name + ", " + std::to_string(panel.handles) + " handles";
  chart.x = {"place along the line, mm", scene.line->from[0], scene.line->to[0], false};
  const auto known = values.array().isFinite();
  const double low = std::min(0.0, known.select(values.array(), 0.0).minCoeff());
  const double high = known.select(values.array(), 0.0).maxCoeff();
  chart.y = axisAround("coordinate", low > -1e-6 ? 0 : low, high);
  for (Eigen::Index handle = 0; handle < values.cols(); ++handle) {
    Curve curve;
    if (handle == 0)
      curve.name = "8 corners";
    else if (handle >= kLongBoxCorners)
      curve.name = handleName(handle);
    curve.x = places(scene, static_cast<int>(values.rows()) - 1);
    curve.y.assign(values.col(handle).begin(), values.col(handle).end());
    curve.pen = penOf(handle);
    chart.curves.push_back(std::move(curve));
  }
  return chart.svg();
}

Table tableOf(const std::string& name, const coordinates::Scene& scene, const PanelResult& result) {
  Table table{name, {"x_mm"}, {}, false};
  const Eigen::MatrixXd values = coordinatesWithGaps(result);
  for (Eigen::Index handle = 0; handle < values.cols(); ++handle)
    table.header.push_back(handleName(handle));
  const auto x = places(scene, static_cast<int>(values.rows()) - 1);
  for (Eigen::Index row = 0; row < values.rows(); ++row) {
    auto& cells = table.rows.emplace_back();
    cells.push_back(significant(x[static_cast<std::size_t>(row)], 6));
    for (Eigen::Index handle = 0; handle < values.cols(); ++handle)
      cells.push_back(std::isfinite(values(row, handle)) ? significant(values(row, handle), 8) : "");
  }
  return table;
}

/// The line and its handles from the front, and the line after one handle has been pulled up.
std::string sketchOf(const Panel& panel, const coordinates::Scene& scene, const PanelResult& result) {
  constexpr double kScale = 4, kWide = 150, kHigh = 84;
  SvgCanvas canvas(kScale * kWide, kScale * kHigh);
  const auto at = [&](const Eigen::RowVector3d& point) {
    return Place{kScale * (kWide / 2 + point[0]), kScale * (kHigh / 2 - point[2])};
  };
  const Points& handles = scene.handles.positions;
  const Eigen::Index pulled = kLongBoxCorners + (handles.rows() - kLongBoxCorners) / 2;
  std::vector<Place> rest, posed;
  const Eigen::MatrixXd values = result.profile.coordinates;
  const int parts = drawnParts(panel);
  for (int i = 0; i <= parts; ++i) {
    const Eigen::RowVector3d point = scene.line->at(static_cast<double>(i) / parts).transpose();
    rest.push_back(at(point));
    posed.push_back(at(point + values(i, pulled) * Eigen::RowVector3d(0, 0, kPull)));
  }
  canvas.polyline(rest, {"#9a9a9a", 1.5, "5 4", 1});
  for (const Place& place : posed)
    canvas.circle(place, 1.3, "#000000");
  for (Eigen::Index handle = 0; handle < handles.rows(); ++handle)
    canvas.circle(at(handles.row(handle)), handle < kLongBoxCorners ? 5 : 6, penOf(handle).color, "#333333");
  const Place from = at(handles.row(pulled)), to = at(handles.row(pulled) + Eigen::RowVector3d(0, 0, kPull));
  canvas.line(from, to, {"#d55e00", 2, {}, 1});
  canvas.circle(to, 6, "#d55e00", "#333333");
  canvas.text({10, 20},
              panel.name + ": " + handleName(pulled) + " pulled up by " + significant(kPull) + " mm", 12);
  canvas.text({10, kScale * kHigh - 10}, "dashed: the line at rest; black: its points; seen from the front",
              11, Anchor::start, "#555555");
  return canvas.svg("the handles around the line, one of them pulled");
}

Finding finding(const Panel& panel, Expect expected, const coordinates::LineProperties& found) {
  const auto of = [&](const std::string& criterion, const std::string& measured, bool met) {
    return Finding{panel.name + ": " + criterion, measured, met};
  };
  const std::string least = "a least coordinate of " + significant(found.report.minWeight);
  const std::string jump = "a largest jump of " + significant(found.largestJump);
  const std::string kinks = found.largestJump > 0 ? jump
                                                  : std::to_string(found.kinks) + " kinks, the largest " +
                                                        significant(found.largestKink) + " /mm";
  switch (expected) {
  case Expect::everywhere:
    return of("coordinates at every point", std::to_string(found.report.failures.size()) + " points without",
              found.report.failures.empty());
  case Expect::positive:
    return of("no coordinate below 0", least, found.report.minWeight >= kNegative);
  case Expect::negative:
    return of("some coordinate below 0", least, found.report.minWeight < kNegative);
  case Expect::continuous:
    return of("no jump", jump, found.largestJump == 0);
  case Expect::jumps:
    return of("a jump", jump, found.largestJump > 0);
  case Expect::smooth:
    return of("neither jump nor kink", kinks, found.largestJump == 0 && found.kinks == 0);
  case Expect::kinks:
    return of("no jump but kinks", kinks, found.largestJump == 0 && found.kinks > 0);
  case Expect::severalMaxima:
    return of("several maxima of one coordinate", std::to_string(found.localMaxima) + " at most",
              found.localMaxima > 1);
  }
  return {};
}

PanelResult measured(const Panel& panel, const coordinates::Scene& scene, const Bench& bench,
                     Progress& progress) {
  const auto system = bench.systems.find(panel.system);
  const auto options = optionsOf(*system, panel, bench.threads);
  PanelResult result;
  result.profile =
      coordinates::profileAlong(*system, scene.handles, *scene.line, drawnParts(panel), options, progress);
  if (panel.profileOnly)
    result.properties.report = result.profile.report;
  else
    result.properties =
        coordinates::measureAlong(*system, scene.handles, *scene.line, kSearchedParts, options, progress);
  return result;
}

void make(const LineFigure& figure, Result& result, const Bench& bench, Progress& progress) {
  result.title = figure.title;
  result.claim = figure.claim;
  result.setup = figure.setup;
  for (const Panel& panel : figure.panels)
    if (!bench.systems.contains(panel.system)) {
      result.problem = "there is no coordinate system " + panel.system;
      return;
    }
  std::vector<PanelResult> all;
  for (const Panel& panel : figure.panels) {
    progress.throwIfCancelled();
    const coordinates::Scene scene = sceneOf(panel);
    const PanelResult& one = all.emplace_back(measured(panel, scene, bench, progress));
    for (const Expect expected : panel.expected)
      result.findings.push_back(finding(panel, expected, one.properties));
    const std::string name =
        result.fileName() +
        (figure.panels.size() > 1 ? std::string("_") + static_cast<char>('a' + all.size() - 1) : "");
    result.pictures.push_back(
        {name, "Coordinates of " + panel.name + " along the line.", plotOf(panel, scene, one)});
    result.tables.push_back(tableOf(name, scene, one));
    if (all.size() == figure.panels.size())
      result.pictures.push_back(
          {result.fileName() + "_line", "The line follows one handle.", sketchOf(panel, scene, one)});
  }
  if (figure.compare)
    for (const Finding& each : figure.compare(all))
      result.findings.push_back(each);
}

} // namespace

Eigen::MatrixXd coordinatesWithGaps(const PanelResult& result) {
  Eigen::MatrixXd values = result.profile.coordinates;
  for (const int failed : result.profile.report.failures)
    values.row(failed).setConstant(std::numeric_limits<double>::quiet_NaN());
  return values;
}

Item itemOf(const LineFigure& figure) {
  return {figure.id, false, [figure](Result& result, const Bench& bench, Progress& progress) {
            make(figure, result, bench, progress);
          }};
}

} // namespace viscera::thesis
