#include <array>
#include <cmath>

#include "charts.h"
#include "figures.h"
#include "timing.h"
#include "viscera/coordinates/systems.h"
#include "viscera/core/text.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/deformation/stress_polynomial.h"
#include "viscera/geometry/volume.h"
#include "viscera/thesis/measured_scenes.h"

namespace viscera::thesis {
namespace {

/// A frame of 30 a second.
constexpr double kInteractiveMs = 1000.0 / 30;

/// Volume and gradient of one organ, posed.
struct VolumeCost {
  std::string organ;
  Eigen::Index vertices = 0, triangles = 0;
  double volumeMs = 0, gradientMs = 0;
};

VolumeCost volumeCost(const std::string& organ, const Bench& bench, Progress& progress) {
  const auto mesh = outerSurface(organ, bench.samples, progress);
  coordinates::HandleSet handles;
  handles.positions = deformation::placeHandles(*mesh);
  coordinates::BindOptions options;
  options.threads = bench.threads;
  const auto binding =
      deformation::bindOrgan(*coordinates::sCelestial(), handles, mesh->points, options, progress);
  Points pose = handles.positions, points, ofPoints, ofHandles;
  pose.row(12) += Eigen::RowVector3d(9, -4, 6);
  binding->deform(pose, points, bench.threads);
  const auto around = geometry::vertexTriangles(points.rows(), mesh->triangles);
  VolumeCost cost{organ, points.rows(), mesh->triangles.rows()};
  double volume = 0;
  cost.volumeMs =
      1e3 * leastSeconds([&] { volume += geometry::volume(points, mesh->triangles, bench.threads); });
  cost.gradientMs = 1e3 * leastSeconds([&] {
                      geometry::volumeGradient(points, mesh->triangles, around, ofPoints, bench.threads);
                      binding->pullBack(pose, ofPoints, ofHandles, bench.threads);
                    });
  return cost;
}

void table52(Result& result, const Bench& bench, Progress& progress) {
  result.title = "Cost of the volume and of its gradient";
  result.claim =
      "Volume and gradient are computed at interactive rates at every size, and their cost grows at most "
      "as the number of vertices.";
  result.setup =
      "Sample organs bound to 30 handles by S-Celestial coordinates; the gradient is that for all handles "
      "at once (the thesis: for one, on a graphics processor). The least of several runs.";
  Table table{"table_5_2", {"organ", "vertices", "triangles", "volume, ms", "gradient, ms"}, {}, true};
  std::vector<VolumeCost> costs;
  const char* organs[] = {"kidney_left@low",          "heart@low", "liver@medium", "heart@medium",
                          "stomach_and_bowel@medium", "heart@high"};
  for (const char* organ : organs) {
    progress.throwIfCancelled();
    const VolumeCost& cost = costs.emplace_back(volumeCost(organ, bench, progress));
    table.rows.push_back({cost.organ, std::to_string(cost.vertices), std::to_string(cost.triangles),
                          fixed(cost.volumeMs, 3), fixed(cost.gradientMs, 3)});
  }
  result.tables.push_back(std::move(table));
  double worst = 0;
  const VolumeCost* largest = &costs.front();
  for (const VolumeCost& cost : costs) {
    worst = std::max(worst, cost.volumeMs + cost.gradientMs);
    if (cost.vertices > largest->vertices)
      largest = &cost;
  }
  result.findings.push_back(
      {"volume and gradient together within " + fixed(kInteractiveMs, 0) + " ms at every size",
       fixed(worst, 2) + " ms at most", worst <= kInteractiveMs});
  const VolumeCost& middle = costs[2];
  const double growth = (largest->volumeMs + largest->gradientMs) / (middle.volumeMs + middle.gradientMs);
  const double sizes = static_cast<double>(largest->vertices) / static_cast<double>(middle.vertices);
  result.findings.push_back(
      {"from " + std::to_string(middle.vertices) + " to " + std::to_string(largest->vertices) +
           " vertices the cost grows by at most 1.5 times the number's growth",
       significant(growth, 3) + " times for " + significant(sizes, 3) + " times the vertices",
       growth <= 1.5 * sizes});
}

void figure54(Result& result, const Bench&, Progress&) {
  result.title = "Rotational stress and the three singular values";
  result.claim = "The largest angle depends on the largest and the smallest singular value only.";
  result.setup = "Searched over directions, as the thesis did (dots), and by the closed form "
                 "arcsin((s1 - s3)/(s1 + s3)) (lines), while the middle value goes from s3 to s1.";
  CurveChart chart;
  chart.title = "Rotational stress while the middle singular value changes";
  chart.x = {"middle singular value s2", 0, 2, false};
  chart.y = {"rotational stress, degrees", 0, 60, false};
  Table table{"figure_5_4", {"s1", "s2", "s3", "searched_deg", "closed_form_deg"}, {}, false};
  constexpr int kSteps = 24;
  const std::array<std::pair<double, double>, 5> pairs{{{2, 0.2}, {2, 0.5}, {2, 1}, {1.5, 0.5}, {1.2, 0.9}}};
  double spread = 0, apart = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto [s1, s3] = pairs[i];
    Curve exact{"s1 = " + significant(s1) + ", s3 = " + significant(s3), {}, {}, penFor(i)};
    Curve searched{"", {}, {}, {exact.pen.color, 5, "1 5", 0.6}};
    double low = 90, high = 0;
    for (int step = 0; step <= kSteps; ++step) {
      const double s2 = s3 + (s1 - s3) * step / kSteps;
      const double found = deformation::searchedStressDegrees(s1, s2, s3);
      low = std::min(low, found);
      high = std::max(high, found);
      apart = std::max(apart, std::abs(found - deformation::stressDegrees(s1, s2, s3)));
      for (Curve* curve : {&exact, &searched})
        curve->x.push_back(s2);
      searched.y.push_back(found);
      exact.y.push_back(deformation::stressDegrees(s1, s2, s3));
      table.rows.push_back({significant(s1), significant(s2, 6), significant(s3), significant(found, 8),
                            significant(exact.y.back(), 8)});
    }
    spread = std::max(spread, high - low);
    chart.curves.push_back(searched);
    chart.curves.push_back(exact);
  }
  result.pictures.push_back({"figure_5_4", "Dots: searched; lines: closed form.", chart.svg()});
  result.tables.push_back(std::move(table));
  result.findings.push_back({"the searched angle changes by less than 0.01 degrees with s2",
                             significant(spread) + " degrees", spread < 0.01});
  result.findings.push_back({"the closed form is within 0.01 degrees of the search",
                             significant(apart) + " degrees", apart < 0.01});
}

void figure55(Result& result, const Bench&, Progress& progress) {
  result.title = "Rotational stress as a polynomial";
  result.claim =
      "A polynomial of degree six in the largest and the smallest singular value is within 0.44 degrees.";
  result.setup =
      "The polynomial of the smallest largest error, fitted for several least ratios s3/s1, which the "
      "thesis does not state. The program uses the closed form.";
  constexpr double kClaimed = 0.44;
  CurveChart angles, errors;
  angles.title = "Rotational stress, exact and by the polynomial fitted down to s3/s1 = 0.1";
  angles.x = errors.x = {"ratio s3/s1", 0, 1, false};
  angles.y = {"rotational stress, degrees", 0, 90, false};
  errors.title = "Error of the polynomials";
  errors.y = {"polynomial less exact, degrees", -1, 1, false};
  Table table{"figure_5_5", {"fitted down to s3/s1", "largest error, degrees"}, {}, true};
  std::size_t index = 0;
  for (const double lowest : {0.3, 0.1, 0.05, 0.01}) {
    progress.throwIfCancelled();
    const deformation::StressPolynomial fit(lowest);
    Curve exact{"exact", {}, {}, penFor(0)}, fitted{"polynomial", {}, {}, {"#d55e00", 2.2, "6 4", 1}};
    Curve error{"down to " + significant(lowest), {}, {}, penFor(index++)};
    for (double ratio = lowest; ratio <= 1 + 1e-9; ratio += 0.0025) {
      const double angle = deformation::stressDegrees(1, 1, ratio);
      for (Curve* curve : {&exact, &fitted, &error})
        curve->x.push_back(ratio);
      exact.y.push_back(angle);
      fitted.y.push_back(fit.degrees(1, ratio));
      error.y.push_back(std::abs(fitted.y.back() - angle) <= 1 ? fitted.y.back() - angle : NAN);
    }
    if (lowest == 0.1)
      angles.curves = {exact, fitted};
    errors.curves.push_back(error);
    table.rows.push_back({significant(lowest), significant(fit.largestError())});
    if (lowest == 0.1 || lowest == 0.01)
      result.findings.push_back({"within 0.44 degrees for all s3 of at least " + significant(lowest) + " s1",
                                 significant(fit.largestError()) + " degrees",
                                 fit.largestError() <= kClaimed});
  }
  for (const double bound : {-kClaimed, kClaimed})
    errors.curves.push_back(
        {bound > 0 ? "0.44 degrees" : "", {0, 1}, {bound, bound}, {"#888888", 1, "3 3", 1}});
  result.pictures.push_back({"figure_5_5_a", "With s1 = 1.", angles.svg()});
  result.pictures.push_back(
      {"figure_5_5_b", "With s1 = 1; beyond one degree the curves are cut.", errors.svg()});
  result.tables.push_back(std::move(table));
}

} // namespace

std::vector<Item> chapter5() {
  return {{"5.2", true, table52}, {"5.4", false, figure54}, {"5.5", false, figure55}};
}

} // namespace viscera::thesis
