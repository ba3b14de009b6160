#include "figures.h"

#include "charts.h"
#include "viscera/coordinates/measure/newton_spread.h"
#include "viscera/core/text.h"
#include "viscera/thesis/measured_scenes.h"

namespace viscera::thesis {
namespace {

using coordinates::NeighbourOrder;
using coordinates::NewtonSpread;

constexpr int kPoints = 1500;
constexpr int kNewtonHandles = 30;
/// A point's neighbours lie within that part of the diagonal of the organ's box.
constexpr double kNeighbourhood = 0.06;

/// One organ, with both orders of the neighbours.
struct Spread {
  std::string organ;
  Eigen::Index points = 0, handles = 0;
  NewtonSpread euclidean, jacobian;
};

std::vector<Spread> spreads(const Bench& bench, Progress& progress) {
  std::vector<Spread> all;
  for (const char* organ : {"heart", "liver", "stomach", "stomach_and_bowel"}) {
    const coordinates::Scene scene = organScene(organ, kNewtonHandles, kPoints, bench.samples, progress);
    coordinates::NewtonSpreadOptions options;
    options.radius = kNeighbourhood * boundsOf(scene.points).diagonal();
    const auto by = [&](NeighbourOrder order) {
      return coordinates::spreadNewton(scene.handles.positions, scene.points, order, options, progress);
    };
    all.push_back({organ, scene.points.rows(), scene.handles.positions.rows(), by(NeighbourOrder::euclidean),
                   by(NeighbourOrder::jacobian)});
  }
  return all;
}

std::string setup() {
  return "The thesis's own procedure, kept for this: T-Celestial by undamped Newton steps to 1e-6, begun "
         "with a "
         "neighbour's solution, \"quickly\" being at most 10 steps, on " +
         std::to_string(kPoints) +
         " vertices of sample organs, neighbours within 6 % of the organ's diagonal; the thesis states "
         "neither. The "
         "program itself begins every point at zero and converges by damping.";
}

std::vector<std::string> groupName(const Spread& spread) {
  return {spread.organ, std::to_string(spread.points) + " (" + std::to_string(spread.handles) + ")"};
}

double percentByFirst(const NewtonSpread& spread) {
  return 100 * spread.shareByFirst();
}

Table tableOf(const std::string& name, const std::vector<Spread>& all) {
  Table table{name,
              {"organ", "order", "points", "by first neighbour", "by second", "by later ones", "unsolved",
               "iterations"},
              {},
              true};
  for (const Spread& spread : all)
    for (const bool jacobian : {false, true}) {
      const NewtonSpread& one = jacobian ? spread.jacobian : spread.euclidean;
      Eigen::Index later = 0;
      for (std::size_t i = 2; i < one.solvedBy.size(); ++i)
        later += one.solvedBy[i];
      const auto count = [&](std::size_t i) {
        return std::to_string(i < one.solvedBy.size() ? one.solvedBy[i] : Eigen::Index(0));
      };
      table.rows.push_back({spread.organ, jacobian ? "jacobian" : "euclidean", std::to_string(spread.points),
                            count(0), count(1), std::to_string(later), std::to_string(one.unsolved),
                            fixed(one.meanIterations, 2)});
    }
  return table;
}

} // namespace

void figure45(Result& result, const Bench& bench, Progress& progress) {
  result.title = "Neighbours tried before Newton's method converges";
  result.claim =
      "Ordered by distance, the first neighbour serves for about half of the points; ordered by the "
      "jacobian, for all.";
  result.setup = setup();
  const auto all = spreads(bench, progress);
  BarChart chart;
  chart.title = "Points solved from the first neighbour tried";
  chart.y = {"share of the points, %", 0, 110, false};
  chart.series = {"euclidean order", "jacobian order"};
  double leastJacobian = 100, mostEuclidean = 0;
  for (const Spread& spread : all) {
    chart.groups.push_back(
        {groupName(spread), {percentByFirst(spread.euclidean), percentByFirst(spread.jacobian)}});
    leastJacobian = std::min(leastJacobian, percentByFirst(spread.jacobian));
    mostEuclidean = std::max(mostEuclidean, percentByFirst(spread.euclidean));
  }
  result.pictures.push_back({result.fileName(), "Below each organ: points (handles).", chart.svg()});
  result.tables.push_back(tableOf(result.fileName(), all));
  result.findings.push_back({"jacobian order: the first neighbour serves for every point",
                             fixed(leastJacobian, 1) + " % at least", leastJacobian >= 100});
  result.findings.push_back({"euclidean order: the first neighbour serves for 40 to 60 % of the points",
                             "up to " + fixed(mostEuclidean, 1) + " %",
                             mostEuclidean <= 60 && mostEuclidean >= 40});
}

void figure46(Result& result, const Bench& bench, Progress& progress) {
  result.title = "Iterations of Newton's method";
  result.claim =
      "From the jacobian order's neighbour it takes a little more iterations than from the nearest one.";
  result.setup = setup();
  const auto all = spreads(bench, progress);
  BarChart chart;
  chart.title = "Mean number of iterations a point";
  double most = 0;
  chart.series = {"euclidean order", "jacobian order"};
  for (const Spread& spread : all) {
    chart.groups.push_back(
        {groupName(spread), {spread.euclidean.meanIterations, spread.jacobian.meanIterations}});
    most = std::max({most, spread.euclidean.meanIterations, spread.jacobian.meanIterations});
    const double ratio = spread.jacobian.meanIterations / spread.euclidean.meanIterations;
    result.findings.push_back({spread.organ + ": more by the jacobian order, by at most half",
                               significant(ratio) + " times as many", ratio >= 1 && ratio <= 1.5});
  }
  chart.y = axisAround("iterations", 0, 1.1 * most);
  result.pictures.push_back({result.fileName(), "Below each organ: points (handles).", chart.svg()});
  result.tables.push_back(tableOf(result.fileName(), all));
}

} // namespace viscera::thesis
