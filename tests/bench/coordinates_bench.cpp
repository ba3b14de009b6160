#include <algorithm>
#include <fstream>
#include <string>

#include <benchmark/benchmark.h>

#include "bench_scenes.h"
#include "viscera/coordinates/systems.h"

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
template <auto makeSystem>
void bind(benchmark::State& state) {
  const geometry::TriangleMesh mesh = bench::bunnyOrBlob();
  HandleSet handles;
  handles.positions = bench::handlesFor(mesh);
  const BindOptions options =
      optionsOf(static_cast<int>(state.range(0)), static_cast<double>(state.range(1)));
  double identity = 0;
  for (auto _ : state) {
    Progress progress;
    identity = makeSystem()->bind(handles, mesh.points, options, progress)->report().identityError;
  }
  countPerWeight(state, mesh.points.rows(), handles.positions.rows());
  state.counters["identity_error_mm"] = identity;
}
BENCHMARK(bind<sCelestial>)
    ->ArgsProduct({{1, 2}, {0, 2}})
    ->ArgNames({"threads", "locality"})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(bind<tCelestial>)
    ->ArgsProduct({{1, 2}, {0, 2}})
    ->ArgNames({"threads", "locality"})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// Points spread evenly over an ellipsoid of 200 x 140 x 100 mm and `scale` times that, along a spiral.
Points onEllipsoid(Eigen::Index count, double scale) {
  const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
  Points points(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double height = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count);
    const double radius = std::sqrt(1 - height * height), angle = turn * static_cast<double>(i);
    points.row(i) << 100 * scale * radius * std::cos(angle), 70 * scale * radius * std::sin(angle),
        50 * scale * height;
  }
  return points;
}

/// A line of /proc/self/status in MiB, 0 where the system has none.
double statusMiB(const std::string& name) {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);)
    if (line.rfind(name + ':', 0) == 0)
      return std::stod(line.substr(name.size() + 1)) / 1024;
  return 0;
}

/// The most memory the process has from now on counts from here.
void forgetPeakMemory() {
  std::ofstream("/proc/self/clear_refs") << 5;
}

/// Arguments: vertices, handles. The counters say what the binding adds to the process' peak of memory, the
/// binding itself included; two threads.
void bindLarge(benchmark::State& state) {
  const Points points = onEllipsoid(state.range(0), 1);
  HandleSet handles;
  handles.positions = onEllipsoid(state.range(1), 1.3);
  BindingReport report;
  double peak = 0;
  for (auto _ : state) {
    state.PauseTiming();
    forgetPeakMemory();
    const double before = statusMiB("VmRSS");
    state.ResumeTiming();
    Progress progress;
    const auto binding = sCelestial()->bind(handles, points, optionsOf(2, 0), progress);
    state.PauseTiming();
    peak = std::max(peak, statusMiB("VmHWM") - before);
    report = binding->report();
    state.ResumeTiming();
  }
  countPerWeight(state, points.rows(), handles.positions.rows());
  state.counters["identity_error_mm"] = report.identityError;
  state.counters["solver_seconds"] = report.seconds;
  state.counters["peak_MiB"] = peak;
}
BENCHMARK(bindLarge)
    ->Name("bind")
    ->Args({62500, 200})
    ->Args({250000, 200})
    ->Args({1000000, 200})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// A pose of all 200 handles of 10^6 vertices, and one handle dragged. Argument: one handle only or not.
void poseLarge(benchmark::State& state) {
  const Points points = onEllipsoid(1000000, 1);
  HandleSet handles;
  handles.positions = onEllipsoid(200, 1.3);
  Progress progress;
  const auto binding = sCelestial()->bind(handles, points, optionsOf(2, 0), progress);
  Points posed = points;
  for (auto _ : state) {
    if (state.range(0) != 0)
      binding->moveHandle(handles.positions, 7, Vec3(1, 2, 3), posed, {2});
    else
      binding->deform(handles.positions, posed, {2});
    benchmark::ClobberMemory();
  }
}
BENCHMARK(poseLarge)->Arg(0)->Arg(1)->ArgName("one")->Unit(benchmark::kMillisecond)->UseRealTime();

/// Closed-form gradients of 20,000 points.
void gradients(benchmark::State& state) {
  const geometry::TriangleMesh mesh = bench::bunnyOrBlob();
  HandleSet handles;
  handles.positions = bench::handlesFor(mesh);
  const Points points = mesh.points.topRows(20000);
  for (auto _ : state) {
    Progress progress;
    benchmark::DoNotOptimize(
        sCelestial()->gradients(handles, points, optionsOf(static_cast<int>(state.range(0)), 0), progress));
  }
  countPerWeight(state, points.rows(), handles.positions.rows());
}
BENCHMARK(gradients)->Arg(1)->Arg(2)->ArgName("threads")->Unit(benchmark::kMillisecond)->UseRealTime();

std::unique_ptr<Binding> boundTo(const geometry::TriangleMesh& mesh, const Points& positions) {
  HandleSet handles;
  handles.positions = positions;
  Progress progress;
  return sCelestial()->bind(handles, mesh.points, {}, progress);
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
