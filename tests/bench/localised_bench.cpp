#include <chrono>

#include <benchmark/benchmark.h>

#include "bench_scenes.h"
#include "viscera/coordinates/systems.h"
#include "viscera/localised_scc/localised_s_celestial.h"

namespace viscera::localised_scc {
namespace {

constexpr int kGroups = 3;
constexpr int kSurfaceHandles = 6;
constexpr double kOverlap = 0.25; ///< Of a part's length.

/// 30 handles in three overlapping groups along the model's longest side: the corners of a box around each
/// part, and two handles off its surface.
coordinates::HandleSet threeGroups(const geometry::TriangleMesh& mesh) {
  const Bounds box = boundsOf(mesh.points);
  Eigen::Index axis = 0;
  (box.high - box.low).maxCoeff(&axis);
  const double length = (box.high - box.low)[axis] / kGroups;
  deformation::Placement sparse;
  sparse.count = kSurfaceHandles;
  sparse.enclosing = false;
  const Points onSurface = deformation::placeHandles(mesh, sparse);
  coordinates::HandleSet handles;
  handles.positions.resize(8 * kGroups + kSurfaceHandles, 3);
  handles.positions.bottomRows(kSurfaceHandles) = onSurface;
  for (int g = 0; g < kGroups; ++g) {
    const double begin = box.low[axis] + (g - kOverlap / 2) * length, end = begin + (1 + kOverlap) * length;
    Bounds part = box;
    part.low[axis] = std::max(begin, box.low[axis]);
    part.high[axis] = std::min(end, box.high[axis]);
    Points corners(2, 3);
    corners << part.low.transpose(), part.high.transpose();
    handles.positions.middleRows(8 * g, 8) = deformation::enclosingHandles(corners, 0.05);
    coordinates::HandleGroup group{"part " + std::to_string(g + 1), {}};
    for (int i = 0; i < 8; ++i)
      group.handles.push_back(8 * g + i);
    for (int i = 0; i < kSurfaceHandles; ++i)
      if (onSurface(i, axis) >= begin && onSurface(i, axis) <= end)
        group.handles.push_back(8 * kGroups + i);
    handles.groups.push_back(std::move(group));
  }
  return handles;
}

double secondsOf(const coordinates::CoordinateSystem& system, const coordinates::HandleSet& handles,
                 const Points& points, const coordinates::BindOptions& options) {
  Progress progress;
  const auto start = std::chrono::steady_clock::now();
  benchmark::DoNotOptimize(system.bind(handles, points, options, progress));
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The localised binding; `times_plain` is its time over that of the plain S-Celestial coordinates with the
/// same handles, bound in turn with it.
void bindLocalised(benchmark::State& state) {
  const geometry::TriangleMesh mesh = bench::bunnyOrBlob();
  const coordinates::HandleSet handles = threeGroups(mesh);
  const auto plain = coordinates::builtInSystems().front();
  const auto localised = localisedSCelestial({plain});
  coordinates::BindOptions options;
  options.threads.count = static_cast<int>(state.range(0));
  double localisedSeconds = 0, plainSeconds = 0;
  for (auto _ : state) {
    const double seconds = secondsOf(*localised, handles, mesh.points, options);
    state.SetIterationTime(seconds);
    localisedSeconds += seconds;
    plainSeconds += secondsOf(*plain, handles, mesh.points, options);
  }
  Progress progress;
  const auto report = localised->bind(handles, mesh.points, options, progress)->report();
  state.counters["vertices"] = static_cast<double>(mesh.points.rows());
  state.counters["handles"] = static_cast<double>(handles.positions.rows());
  state.counters["groups"] = kGroups;
  state.counters["failures"] = static_cast<double>(report.failures.size());
  state.counters["identity_error_mm"] = report.identityError;
  state.counters["times_plain"] = localisedSeconds / plainSeconds;
}
BENCHMARK(bindLocalised)->Arg(1)->Arg(2)->ArgName("threads")->Unit(benchmark::kMillisecond)->UseManualTime();

/// What a dragged handle costs beside the binding: regions, zones and super-regions anew.
void layoutOfGroups(benchmark::State& state) {
  const coordinates::HandleSet handles = threeGroups(bench::bunnyOrBlob());
  const auto localised = localisedSCelestial({coordinates::builtInSystems().front()});
  for (auto _ : state)
    benchmark::DoNotOptimize(localised->layout(handles, {}));
}
BENCHMARK(layoutOfGroups)->Unit(benchmark::kMicrosecond);

} // namespace
} // namespace viscera::localised_scc
