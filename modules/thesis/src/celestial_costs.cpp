#include "figures.h"

#include <algorithm>
#include <cmath>

#include "charts.h"
#include "timing.h"
#include "viscera/core/error.h"
#include "viscera/core/text.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/deformation/tetrahedralise.h"
#include "viscera/thesis/measured_scenes.h"

namespace viscera::thesis {
namespace {

using coordinates::BindOptions;
using coordinates::CoordinateSystem;

/// Seconds that one thread takes for binding; the least of some runs.
double seconds(const CoordinateSystem& system, const coordinates::HandleSet& handles, const Points& points,
               const BindOptions& options, Progress& progress) {
  return leastSeconds([&] { (void)system.bind(handles, points, options, progress); });
}

/// The times of two systems on organs, one chart and one table.
struct Comparison {
  std::string first, second; ///< Ids.
  std::vector<std::string> organs;
  bool logarithmic = false;
};

struct Pair {
  double first = NAN, second = NAN;
};

std::vector<Pair> compare(const Comparison& comparison, Result& result, const Bench& bench,
                          Progress& progress) {
  const auto first = bench.systems.find(comparison.first), second = bench.systems.find(comparison.second);
  BindOptions options = deformation::withTetgen({});
  options.threads = Threads{1};
  BarChart chart;
  chart.title = "Time to bind, one thread";
  chart.series = {first->name(), second->name()};
  Table table{result.fileName(),
              {"organ", "vertices", "handles", first->name() + ", s", second->name() + ", s"},
              {},
              true};
  std::vector<Pair> all;
  double most = 0, least = INFINITY;
  for (const std::string& organ : comparison.organs) {
    const auto mesh = outerSurface(organ, bench.samples, progress);
    coordinates::HandleSet handles;
    handles.positions = deformation::placeHandles(*mesh);
    const auto [ofFirst, ofSecond] =
        leastSecondsInTurn([&] { (void)first->bind(handles, mesh->points, options, progress); },
                           [&] { (void)second->bind(handles, mesh->points, options, progress); });
    const Pair pair{ofFirst, ofSecond};
    const std::string vertices = std::to_string(mesh->points.rows()),
                      count = std::to_string(handles.positions.rows());
    chart.groups.push_back({{organ, vertices + " (" + count + ")"}, {pair.first, pair.second}});
    table.rows.push_back({organ, vertices, count, significant(pair.first), significant(pair.second)});
    most = std::max({most, pair.first, pair.second});
    least = std::min({least, pair.first, pair.second});
    all.push_back(pair);
  }
  chart.y = axisAround("seconds", 0, 1.1 * most);
  if (comparison.logarithmic)
    chart.y = {"seconds", std::pow(10, std::floor(std::log10(least))),
               std::pow(10, std::ceil(std::log10(2 * most))), true};
  result.pictures.push_back({result.fileName(), "Below each organ: vertices (handles).", chart.svg()});
  result.tables.push_back(std::move(table));
  return all;
}

/// "the second needs at most `share` of the first's time on every organ"
Finding atMost(const std::vector<Pair>& pairs, double share, const std::string& criterion) {
  double worst = 0;
  for (const Pair& pair : pairs)
    worst = std::max(worst, pair.second / pair.first);
  return {criterion, significant(worst, 2) + " times as long at most", worst <= share};
}

} // namespace

void figure412(Result& result, const Bench& bench, Progress& progress) {
  result.title = "Cost of T- and S-Celestial coordinates";
  result.claim = "S-Celestial coordinates are much more efficient than T-Celestial ones.";
  result.setup =
      "Both by the same damped Newton method, which needs no neighbours; sample organs with 30 handles.";
  const auto pairs = compare(
      {"t-celestial",
       "s-celestial",
       {"kidney_left@medium", "stomach@medium", "liver@medium", "heart@medium", "stomach_and_bowel@medium"}},
      result, bench, progress);
  result.findings.push_back(atMost(pairs, 1, "S-Celestial takes less time than T-Celestial on every organ"));
  result.findings.push_back(
      atMost(pairs, 0.5, "S-Celestial takes at most half the time (\"much more efficient\")"));
}

void figure418(Result& result, const Bench& bench, Progress& progress) {
  result.title = "Cost of C-, T- and S-Celestial coordinates";
  result.claim =
      "S-Celestial coordinates are the most efficient, C-Celestial ones with 100,000 samples cannot be "
      "afforded.";
  result.setup =
      "A line of 1,000 points among 15 handles, one thread. C-Celestial is timed on 50 of the points and "
      "multiplied: each is solved by itself.";
  constexpr int kPoints = 1000, kTimed = 50;
  const coordinates::Scene scene = lineScene(15);
  Points points(kPoints, 3), few(kTimed, 3);
  for (int i = 0; i < kPoints; ++i)
    points.row(i) = scene.line->at(i / (kPoints - 1.0)).transpose();
  for (int i = 0; i < kTimed; ++i)
    few.row(i) = points.row(i * kPoints / kTimed);
  BindOptions options, sampled;
  options.threads = sampled.threads = Threads{1};
  const auto c = bench.systems.find("c-celestial");
  sampled.parameters.setFromText(c->parameters(), "sampling", "sphere");
  sampled.parameters.setFromText(c->parameters(), "samples", "100000");
  const double ofC = seconds(*c, scene.handles, few, sampled, progress) * kPoints / kTimed;
  const double ofT = seconds(*bench.systems.find("t-celestial"), scene.handles, points, options, progress);
  const double ofS = seconds(*bench.systems.find("s-celestial"), scene.handles, points, options, progress);
  BarChart chart;
  chart.title = "Time to bind a line of 1,000 points, one thread";
  chart.y = {"seconds", std::pow(10, std::floor(std::log10(std::min(ofS, ofT)))),
             std::pow(10, std::ceil(std::log10(2 * ofC))), true};
  chart.series = {"seconds"};
  chart.groups = {
      {{"C-Celestial", "100,000 samples"}, {ofC}}, {{"T-Celestial"}, {ofT}}, {{"S-Celestial"}, {ofS}}};
  result.pictures.push_back({result.fileName(), "Logarithmic.", chart.svg()});
  result.tables.push_back({result.fileName(),
                           {"system", "seconds"},
                           {{"c-celestial, 100,000 samples", significant(ofC)},
                            {"t-celestial", significant(ofT)},
                            {"s-celestial", significant(ofS)}},
                           true});
  result.findings.push_back({"S-Celestial takes the least time",
                             significant(ofS) + " s, T-Celestial " + significant(ofT) + " s",
                             ofS <= ofT && ofS <= ofC});
  result.findings.push_back({"C-Celestial takes at least 100 times as long as both",
                             significant(ofC / std::max(ofS, ofT)) + " times",
                             ofC >= 100 * std::max(ofS, ofT)});
}

void figure423(Result& result, const Bench& bench, Progress& progress) {
  result.title = "Cost of bounded biharmonic weights and S-Celestial coordinates";
  result.claim = "S-Celestial coordinates are much more efficient than bounded biharmonic weights.";
  result.setup =
      "Sample organs with 30 handles; the time for the weights includes filling the organ with tetrahedra.";
  constexpr auto kWeights = "bounded-biharmonic";
  if (!bench.systems.contains(kWeights)) {
    result.problem = std::string("there is no coordinate system ") + kWeights;
    return;
  }
  const auto pairs = compare({kWeights, "s-celestial", {"kidney_left@low", "liver@low", "heart@low"}, true},
                             result, bench, progress);
  result.findings.push_back(
      atMost(pairs, 0.1, "S-Celestial takes at most a tenth of the time on every organ"));
}

} // namespace viscera::thesis
