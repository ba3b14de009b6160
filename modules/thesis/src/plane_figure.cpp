#include "figures.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "svg_canvas.h"
#include "viscera/coordinates/coordinate_system.h"
#include "viscera/coordinates/planar.h"
#include "viscera/core/text.h"

namespace viscera::thesis {
namespace {

using coordinates::PlanarWeights;
using coordinates::PointsOf;

constexpr int kAcross = 120; ///< Points of a map in each direction.
constexpr double kExactInFigures = 1e-9;
constexpr double kPanel = 220, kTitle = 44, kGap = 20, kMargin = 14; ///< In the picture's units.
constexpr int kColumns = 4;
constexpr int kBands = 10; ///< Of a tenth each.
constexpr auto kNegativeColor = "#f0a06a";

/// A polygon of handles with the handle whose influence is shown.
struct Polygon {
  std::string name;
  PointsOf<2> corners; ///< In order, mm.
  Eigen::Index shown;
};

Polygon convexPolygon() {
  Polygon polygon{"convex", PointsOf<2>(7, 2), 2};
  polygon.corners << 12.3, 8.1, 58.6, 2.2, 92.7, 30.4, 88.1, 66.3, 55.2, 96.4, 20.9, 84.7, 3.1, 46.2;
  return polygon;
}

/// The letter U with a corner of its notch shown: edges hide one arm from the other.
Polygon concavePolygon() {
  Polygon polygon{"concave", PointsOf<2>(8, 2), 4};
  polygon.corners << 4, 96, 4, 4, 96, 4, 96, 96, 66, 96, 62, 36, 38, 36, 34, 96;
  return polygon;
}

bool inside(const PointsOf<2>& corners, const Eigen::RowVector2d& point) {
  bool within = false;
  for (Eigen::Index i = 0, before = corners.rows() - 1; i < corners.rows(); before = i++) {
    const Eigen::RowVector2d a = corners.row(i), b = corners.row(before);
    if ((a[1] > point[1]) != (b[1] > point[1]) &&
        point[0] < a[0] + (b[0] - a[0]) * (point[1] - a[1]) / (b[1] - a[1]))
      within = !within;
  }
  return within;
}

/// The middles of a square lattice's cells, row by row, that lie in the polygon.
struct Lattice {
  std::vector<std::pair<int, int>> cells; ///< Column, row.
  PointsOf<2> points;
};

Lattice latticeIn(const Polygon& polygon) {
  Lattice lattice;
  for (int row = 0; row < kAcross; ++row)
    for (int column = 0; column < kAcross; ++column)
      if (inside(polygon.corners, Eigen::RowVector2d(column + 0.5, row + 0.5) * 100 / kAcross))
        lattice.cells.emplace_back(column, row);
  lattice.points.resize(static_cast<Eigen::Index>(lattice.cells.size()), 2);
  for (std::size_t i = 0; i < lattice.cells.size(); ++i)
    lattice.points.row(static_cast<Eigen::Index>(i)) << (lattice.cells[i].first + 0.5) * 100 / kAcross,
        (lattice.cells[i].second + 0.5) * 100 / kAcross;
  return lattice;
}

/// Statistics of a map over all handles and all points that have coordinates.
struct Measured {
  double unity = 0;    ///< Largest difference of a sum from 1.
  double identity = 0; ///< Largest distance of a point from where its coordinates put it, of the size.
  double lagrange = 0; ///< Largest difference from 1 at the own handle and 0 at the others.
  double least = 0;
  Eigen::Index negative = 0; ///< Points with a negative coordinate.
  std::size_t gaps = 0;      ///< Points without coordinates.
};

Measured measure(const Polygon& polygon, const Lattice& lattice, const PlanarWeights& found,
                 const PlanarWeights& atHandles) {
  const double size = (polygon.corners.colwise().maxCoeff() - polygon.corners.colwise().minCoeff()).norm();
  Measured measured;
  measured.gaps = found.failures.size();
  for (Eigen::Index i = 0; i < found.weights.rows(); ++i) {
    if (std::binary_search(found.failures.begin(), found.failures.end(), static_cast<int>(i)))
      continue;
    const Eigen::RowVectorXd row = found.weights.row(i);
    measured.unity = std::max(measured.unity, std::abs(row.sum() - 1));
    measured.identity =
        std::max(measured.identity, (row * polygon.corners - lattice.points.row(i)).norm() / size);
    measured.least = std::min(measured.least, row.minCoeff());
    measured.negative += row.minCoeff() < -kExactInFigures ? 1 : 0;
  }
  const Eigen::Index handles = polygon.corners.rows();
  measured.lagrange = (atHandles.weights - Eigen::MatrixXd::Identity(handles, handles)).cwiseAbs().maxCoeff();
  return measured;
}

/// White to blue in bands, so that their borders are lines of equal influence; negative in orange.
std::string bandColor(int band) {
  if (band < 0)
    return kNegativeColor;
  const double share = (band + 0.5) / kBands;
  const auto part = [&](double light, double dark) {
    return std::to_string(static_cast<int>(std::lround(light + share * (dark - light))));
  };
  return "rgb(" + part(247, 8) + "," + part(251, 48) + "," + part(255, 107) + ")";
}

/// One map with its polygon and handles, `corner` being the upper left of its square.
void drawMap(SvgCanvas& canvas, Place corner, const Polygon& polygon, const Lattice& lattice,
             const PlanarWeights& found) {
  const double cell = kPanel / kAcross;
  const auto at = [&](const Eigen::RowVector2d& point) {
    return Place{corner.x + point[0] * kPanel / 100, corner.y + kPanel - point[1] * kPanel / 100};
  };
  const std::set<int> gaps(found.failures.begin(), found.failures.end());
  const auto bandOf = [&](std::size_t i) {
    const double value = found.weights(static_cast<Eigen::Index>(i), polygon.shown);
    if (gaps.count(static_cast<int>(i)))
      return kBands; // Nothing there.
    return value < -kExactInFigures ? -1 : std::clamp(static_cast<int>(value * kBands), 0, kBands - 1);
  };
  for (std::size_t from = 0, to = 0; from < lattice.cells.size(); from = to) {
    const auto [column, row] = lattice.cells[from];
    const int band = bandOf(from);
    while (to < lattice.cells.size() && lattice.cells[to].second == row &&
           lattice.cells[to].first - column == static_cast<int>(to - from) && bandOf(to) == band)
      ++to;
    if (band < kBands)
      canvas.rectangle({corner.x + column * cell, corner.y + kPanel - (row + 1) * cell},
                       static_cast<double>(to - from) * cell, cell * 1.05, bandColor(band));
  }
  std::vector<Place> outline;
  for (Eigen::Index i = 0; i <= polygon.corners.rows(); ++i)
    outline.push_back(at(polygon.corners.row(i % polygon.corners.rows())));
  canvas.polyline(outline, {"#333333", 1.2, {}, 1});
  for (Eigen::Index i = 0; i < polygon.corners.rows(); ++i)
    canvas.circle(at(polygon.corners.row(i)), i == polygon.shown ? 5 : 3,
                  i == polygon.shown ? "#d55e00" : "#ffffff", "#333333");
}

void drawLegend(SvgCanvas& canvas, Place corner) {
  canvas.text(corner, "influence of the orange handle", 11);
  for (int band = -1; band < kBands; ++band) {
    const Place place{corner.x + (band + 1) * 18, corner.y + 10};
    canvas.rectangle(place, 18, 14, bandColor(band));
    if (band >= 0 && band % 5 == 0)
      canvas.text({place.x, place.y + 28}, fixed(static_cast<double>(band) / kBands, 1), 10, Anchor::middle);
  }
  canvas.text({corner.x + 11 * 18, corner.y + 38}, "1.0", 10, Anchor::middle);
  canvas.text({corner.x, corner.y + 56}, "first box: negative; white: no coordinates", 10);
}

void addFindings(Result& result, const Polygon& polygon, const std::string& name, const std::string& id,
                 const Measured& measured) {
  const std::string begin = name + ", " + polygon.name + " polygon: ";
  const double worst = std::max({measured.unity, measured.identity, measured.lagrange});
  result.findings.push_back(
      {begin + "sums of one, every point reproduced, one at its handle and nothing at others",
       "errors of " + significant(measured.unity) + ", " + significant(measured.identity) + " and " +
           significant(measured.lagrange),
       worst <= kExactInFigures});
  const bool mayBeNegative = id == "mean-value" && polygon.name == "concave";
  result.findings.push_back(
      {begin + (mayBeNegative ? "some coordinate below 0" : "no coordinate below 0"),
       std::to_string(measured.negative) + " points with one, the least " + significant(measured.least),
       mayBeNegative == (measured.negative > 0)});
  if (id != "wire-approach")
    result.findings.push_back({begin + "coordinates everywhere",
                               std::to_string(measured.gaps) + " points without", measured.gaps == 0});
  else if (polygon.name == "convex")
    result.findings.push_back({begin + "some points without coordinates",
                               std::to_string(measured.gaps) + " points without", measured.gaps > 0});
}

/// Every planar system in one polygon: a picture, the numbers of the shown handle, the measures.
void addPolygon(Result& result, const Polygon& polygon, const Bench& bench, Progress& progress,
                Table& measures) {
  const Lattice lattice = latticeIn(polygon);
  const std::vector<std::string> systems = coordinates::planarSystems();
  const double step = kPanel + kGap;
  const int rows = (static_cast<int>(systems.size()) + kColumns) / kColumns; // With the legend.
  SvgCanvas canvas(2 * kMargin + kColumns * step - kGap, rows * (kPanel + kTitle) + kMargin);
  Table numbers{result.fileName() + "_" + polygon.name, {"x_mm", "y_mm"}, {}, false};
  for (const auto& point : lattice.points.rowwise())
    numbers.rows.push_back({significant(point[0], 6), significant(point[1], 6)});
  const auto place = [&](std::size_t index) {
    return Place{kMargin + static_cast<double>(index % kColumns) * step,
                 static_cast<double>(index / kColumns) * (kPanel + kTitle) + kTitle};
  };
  for (std::size_t s = 0; s < systems.size(); ++s) {
    progress.throwIfCancelled();
    const auto found =
        coordinates::planarWeights(systems[s], polygon.corners, lattice.points, {}, bench.threads);
    const auto atHandles = coordinates::planarWeights(systems[s], polygon.corners, polygon.corners);
    const std::string name = bench.systems.find(systems[s])->name();
    const Measured measured = measure(polygon, lattice, found, atHandles);
    addFindings(result, polygon, name, systems[s], measured);
    measures.rows.push_back({name, polygon.name, significant(measured.unity), significant(measured.identity),
                             significant(measured.lagrange), significant(measured.least),
                             std::to_string(measured.negative), std::to_string(measured.gaps)});
    canvas.text({place(s).x, place(s).y - 10}, name, 12);
    drawMap(canvas, place(s), polygon, lattice, found);
    numbers.header.push_back(systems[s]);
    const std::set<int> gaps(found.failures.begin(), found.failures.end());
    for (std::size_t i = 0; i < numbers.rows.size(); ++i)
      numbers.rows[i].push_back(
          gaps.count(static_cast<int>(i))
              ? ""
              : significant(found.weights(static_cast<Eigen::Index>(i), polygon.shown), 8));
  }
  drawLegend(canvas, {place(systems.size()).x + 8, place(systems.size()).y + 40});
  result.pictures.push_back({numbers.name,
                             "A handle's influence in a " + polygon.name + " polygon of " +
                                 std::to_string(polygon.corners.rows()) + " handles, " +
                                 std::to_string(lattice.points.rows()) +
                                 " points. Borders of colours are lines of equal influence.",
                             canvas.svg("Influence in a " + polygon.name + " polygon")});
  result.tables.push_back(std::move(numbers));
}

} // namespace

void planeFigure(Result& result, const Bench& bench, Progress& progress) {
  result.title = "Influence of one handle in the plane";
  result.claim =
      "The systems are stated for any dimension. In the plane, as in space, coordinates sum to one, "
      "reproduce the point, are one at their own handle and positive; the wire leaves gaps; mean value "
      "coordinates, which need a polygon, are negative in places when it is concave.";
  result.setup =
      "Not a picture of the thesis. The two-dimensional form of every system that has one, on a lattice "
      "within the polygon. Only mean value coordinates know its edges; the others see the handles alone, "
      "so that their influence passes from one arm of the concave polygon to the other.";
  Table measures{result.fileName(),
                 {"system", "polygon", "unity error", "identity error", "error at handles",
                  "least coordinate", "points with a negative one", "points without"},
                 {},
                 true};
  for (const Polygon& polygon : {convexPolygon(), concavePolygon()})
    addPolygon(result, polygon, bench, progress, measures);
  result.tables.push_back(std::move(measures));
}

} // namespace viscera::thesis
