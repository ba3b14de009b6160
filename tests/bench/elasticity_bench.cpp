#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <string>

#include <benchmark/benchmark.h>

#include "bench_scenes.h"
#include "viscera/elasticity/elastic_organ.h"

/// The elastic organ: filling it with tetrahedra, one element, and the equilibrium under a dragged handle.
namespace viscera {
namespace {

/// A line of /proc/self/status in MiB, 0 where the system has none.
double memoryMiB(const std::string& name) {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);)
    if (line.rfind(name + ':', 0) == 0)
      return std::stod(line.substr(name.size() + 1)) / 1024;
  return 0;
}

/// The most memory the process has from now on counts from here.
void forgetMemoryPeak() {
  std::ofstream("/proc/self/clear_refs") << 5;
}

elasticity::ElasticOrgan elasticBlob(const geometry::TriangleMesh& surface, int tetrahedra) {
  elasticity::OrganOptions options;
  options.tetrahedra = tetrahedra;
  Progress progress;
  return {surface, options, std::make_shared<elasticity::NeoHookean>(6, 0.49), progress};
}

void fillOrgan(benchmark::State& state) {
  const geometry::TriangleMesh surface = bench::blob(60, 90);
  Eigen::Index tetrahedra = 0;
  for (auto _ : state)
    tetrahedra = elasticBlob(surface, static_cast<int>(state.range(0))).body().mesh().tetrahedra.rows();
  state.counters["tetrahedra"] = static_cast<double>(tetrahedra);
}
BENCHMARK(fillOrgan)
    ->Arg(600)
    ->Arg(2400)
    ->Arg(10000)
    ->ArgName("wanted")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// Force and stiffness of one tetrahedron.
void elementShare(benchmark::State& state) {
  const elasticity::ElasticOrgan organ = elasticBlob(bench::blob(60, 90), 600);
  const Values rest = Values::Zero(organ.body().unknowns());
  elasticity::ElementShare share;
  for (auto _ : state) {
    organ.body().shareOf(0, rest, share);
    benchmark::DoNotOptimize(share.energy);
  }
}
BENCHMARK(elementShare)->Unit(benchmark::kMicrosecond);

/// One of thirty handles is dragged by 3 % of the diagonal, the others hold. Arguments: tetrahedra, threads.
/// The counter `peak_MiB` is what a solution adds to the memory of the process.
void draggedHandle(benchmark::State& state) {
  const geometry::TriangleMesh surface = bench::blob(60, 90);
  const elasticity::ElasticOrgan organ = elasticBlob(surface, static_cast<int>(state.range(0)));
  const Points rest = bench::handlesFor(surface);
  Points pose = rest;
  pose.row(0) += 0.03 * boundsOf(surface.points).diagonal() * Eigen::RowVector3d(0.6, 0.64, 0.48);
  const elasticity::Grips grips = elasticity::gripsOf(organ, rest, pose, {});
  elasticity::SolveOptions options;
  options.threads = Threads{static_cast<int>(state.range(1))};
  elasticity::StaticSolution solution;
  double peak = 0;
  for (auto _ : state) {
    state.PauseTiming();
    forgetMemoryPeak();
    const double before = memoryMiB("VmRSS");
    state.ResumeTiming();
    Progress progress;
    solution = elasticity::solveStatic(organ.body(), {grips.prescribed, {}}, options, progress);
    state.PauseTiming();
    peak = std::max(peak, memoryMiB("VmHWM") - before);
    state.ResumeTiming();
  }
  state.counters["tetrahedra"] = static_cast<double>(organ.body().mesh().tetrahedra.rows());
  state.counters["unknowns"] = static_cast<double>(organ.body().unknowns());
  state.counters["newtonSteps"] = solution.iterations;
  state.counters["peak_MiB"] = peak;
}
BENCHMARK(draggedHandle)
    ->ArgsProduct({{600, 2400, 10000}, {1, 2}})
    ->ArgNames({"wanted", "threads"})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace
} // namespace viscera
