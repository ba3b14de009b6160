#include <benchmark/benchmark.h>

#include "bench_scenes.h"
#include "viscera/coordinates/systems.h"
#include "viscera/deformation/grid_witnesses.h"
#include "viscera/deformation/tetrahedralise.h"
#include "viscera/deformation/witness_gradients.h"
#include "viscera/geometry/volume.h"

namespace viscera::deformation {
namespace {

struct Scene {
  geometry::TriangleMesh organ = bench::blob(60, 90);
  coordinates::HandleSet handles;
  WitnessMesh mesh;

  explicit Scene(int witnesses) {
    handles.positions = bench::handlesFor(organ);
    Progress progress;
    mesh = gridWitnesses(organ, witnesses, progress);
  }
};

/// A new pose's full map: 20,000 witnesses, 30 handles. Argument: threads.
void stressMap(benchmark::State& state) {
  const Scene scene(20'000);
  const Threads threads{static_cast<int>(state.range(0))};
  Progress progress;
  const auto gradients =
      bindWitnesses(*coordinates::sCelestial(), scene.handles, scene.mesh.points, {{}, threads}, progress);
  Points pose = scene.handles.positions;
  StressMap map;
  int step = 0;
  for (auto _ : state) {
    pose(12, 0) += (++step % 2 ? 1 : -1) * 7.5;
    gradients->evaluate(pose, map, threads);
    benchmark::DoNotOptimize(map.rotationalStress.data());
  }
  state.counters["witnesses"] = static_cast<double>(scene.mesh.witnesses);
  state.counters["handles"] = static_cast<double>(pose.rows());
}
BENCHMARK(stressMap)->Arg(1)->Arg(2)->ArgName("threads")->Unit(benchmark::kMillisecond)->UseRealTime();

/// What comes before: the derivatives, once for a set of handles.
void witnessDerivatives(benchmark::State& state) {
  const Scene scene(20'000);
  const Threads threads{static_cast<int>(state.range(0))};
  Progress progress;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        bindWitnesses(*coordinates::sCelestial(), scene.handles, scene.mesh.points, {{}, threads}, progress));
}
BENCHMARK(witnessDerivatives)
    ->Arg(1)
    ->Arg(2)
    ->ArgName("threads")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// One run of TetGen in its process for so many tetrahedra's volumes.
void tetrahedra(benchmark::State& state) {
  const geometry::TriangleMesh organ = bench::blob(60, 90);
  TetrahedraOptions options;
  options.maxVolumeMm3 =
      geometry::volume(organ.points, organ.triangles) / (4.7 * static_cast<double>(state.range(0)));
  Progress progress;
  for (auto _ : state)
    state.counters["witnesses"] = static_cast<double>(tetrahedralise(organ, options, progress).witnesses);
}
BENCHMARK(tetrahedra)
    ->Arg(2000)
    ->Arg(20'000)
    ->ArgName("wanted")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace
} // namespace viscera::deformation
