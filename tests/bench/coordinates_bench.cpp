#include <benchmark/benchmark.h>

#include "bench_scenes.h"
#include "viscera/coordinates/celestial/s_celestial.h"
#include "viscera/coordinates/celestial/t_celestial.h"

namespace viscera::coordinates {
namespace {

/// Time a vertex and handle, shown in seconds: the reporter writes 5n for 5 ns.
void countPerWeight(benchmark::State& state, Eigen::Index vertices, Eigen::Index handles) {
  state.counters["vertices"] = static_cast<double>(vertices);
  state.counters["handles"] = static_cast<double>(handles);
  state.counters["per_vertex_handle"] =
      benchmark::Counter(static_cast<double>(vertices * handles),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

BindOptions optionsOf(int threads, double locality) {
  BindOptions options;
  options.threads.count = threads;
  options.parameters.set("locality", locality);
  return options;
}

/// Arguments: threads, locality.
template <class System>
void bind(benchmark::State& state) {
  const geometry::TriangleMesh mesh = bench::bunnyOrBlob();
  HandleSet handles;
  handles.positions = bench::handlesFor(mesh);
  const BindOptions options =
      optionsOf(static_cast<int>(state.range(0)), static_cast<double>(state.range(1)));
  double identity = 0;
  for (auto _ : state) {
    Progress progress;
    identity = System().bind(handles, mesh.points, options, progress)->report().identityError;
  }
  countPerWeight(state, mesh.points.rows(), handles.positions.rows());
  state.counters["identity_error_mm"] = identity;
}
BENCHMARK(bind<SCelestial>)
    ->ArgsProduct({{1, 2}, {0, 2}})
    ->ArgNames({"threads", "locality"})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(bind<TCelestial>)
    ->ArgsProduct({{1, 2}, {0, 2}})
    ->ArgNames({"threads", "locality"})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// Closed-form gradients of 20,000 points.
void gradients(benchmark::State& state) {
  const geometry::TriangleMesh mesh = bench::bunnyOrBlob();
  HandleSet handles;
  handles.positions = bench::handlesFor(mesh);
  const Points points = mesh.points.topRows(20000);
  for (auto _ : state) {
    Progress progress;
    benchmark::DoNotOptimize(
        SCelestial().gradients(handles, points, optionsOf(static_cast<int>(state.range(0)), 0), progress));
  }
  countPerWeight(state, points.rows(), handles.positions.rows());
}
BENCHMARK(gradients)->Arg(1)->Arg(2)->ArgName("threads")->Unit(benchmark::kMillisecond)->UseRealTime();

std::unique_ptr<Binding> boundTo(const geometry::TriangleMesh& mesh, const Points& positions) {
  HandleSet handles;
  handles.positions = positions;
  Progress progress;
  return SCelestial().bind(handles, mesh.points, {}, progress);
}

/// A new pose of all handles. Arguments: threads, large mesh or not.
void poseAllHandles(benchmark::State& state) {
  const geometry::TriangleMesh mesh = state.range(1) != 0 ? bench::largeBlob() : bench::bunnyOrBlob();
  const Points pose = bench::handlesFor(mesh);
  const auto binding = boundTo(mesh, pose);
  Points points;
  for (auto _ : state) {
    binding->deform(pose, points, {static_cast<int>(state.range(0))});
    benchmark::ClobberMemory();
  }
  countPerWeight(state, mesh.points.rows(), pose.rows());
}
BENCHMARK(poseAllHandles)
    ->ArgsProduct({{1, 2}, {0, 1}})
    ->ArgNames({"threads", "large"})
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime();

/// The same product by a plain Eigen matrix, in its best layout: what the tiles are compared with.
void poseByPlainMatrix(benchmark::State& state) {
  const geometry::TriangleMesh mesh = state.range(0) != 0 ? bench::largeBlob() : bench::bunnyOrBlob();
  const Points pose = bench::handlesFor(mesh);
  const auto binding = boundTo(mesh, pose);
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> weights(mesh.points.rows(),
                                                                                 pose.rows());
  for (int handle = 0; handle < static_cast<int>(pose.rows()); ++handle)
    weights.col(handle) = binding->influence(handle);
  Points points(mesh.points.rows(), 3);
  for (auto _ : state) {
    points.noalias() = weights * pose;
    benchmark::ClobberMemory();
  }
  countPerWeight(state, mesh.points.rows(), pose.rows());
}
BENCHMARK(poseByPlainMatrix)->Arg(0)->Arg(1)->ArgName("large")->Unit(benchmark::kMicrosecond)->UseRealTime();

} // namespace
} // namespace viscera::coordinates
