#include <benchmark/benchmark.h>

#include "bench_scenes.h"
#include "viscera/coordinates/systems.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/deformation/volume_lock.h"
#include "viscera/geometry/volume.h"
#include "viscera/live/tissue_energy.h"

/// A step of a drag that free handles follow.
namespace viscera {
namespace {

/// Thirty handles around an organ, of which one is dragged, eight hold it and the others follow. Arguments:
/// threads, and whether its volume is locked.
void followingStep(benchmark::State& state) {
  const Threads threads{static_cast<int>(state.range(0))};
  const auto organ = std::make_shared<const geometry::TriangleMesh>(bench::blob(60, 90));
  coordinates::HandleSet handles;
  handles.positions = bench::handlesFor(*organ);
  Progress progress;
  const auto system = coordinates::sCelestial();
  const auto tissue = live::tissueEnergy({organ}, *system, handles, {{}, threads}, progress);
  const deformation::VolumeLock lock(
      {{"organ", organ, deformation::bindOrgan(*system, handles, organ->points, {{}, threads}, progress),
        geometry::volume(organ->points, organ->triangles, threads)}},
      threads);
  lock.makeForms(progress);
  const auto dragged = static_cast<int>(handles.positions.rows()) - 1;
  std::vector<int> free;
  for (int row = 0; row < dragged; ++row)
    if (row % 4 != 0)
      free.push_back(row);
  Points pose = handles.positions;
  int step = 0, newtonSteps = 0;
  for (auto _ : state) {
    // Back and forth by up to 20 mm, 2 mm a step.
    pose(dragged, 0) += ++step % 20 < 10 ? 2 : -2;
    const elasticity::RelaxedPose relaxed = tissue->relax(pose, free, state.range(1) ? &lock : nullptr);
    pose = relaxed.pose;
    newtonSteps += relaxed.steps;
  }
  state.counters["witnesses"] = static_cast<double>(tissue->witnesses());
  state.counters["handles"] = static_cast<double>(pose.rows());
  state.counters["newtonSteps"] = static_cast<double>(newtonSteps) / static_cast<double>(state.iterations());
}
BENCHMARK(followingStep)
    ->ArgsProduct({{1, 2}, {0, 1}})
    ->ArgNames({"threads", "locked"})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// What comes before the first step: witness points and the derivatives there.
void tissueOfAnOrgan(benchmark::State& state) {
  const auto organ = std::make_shared<const geometry::TriangleMesh>(bench::blob(60, 90));
  coordinates::HandleSet handles;
  handles.positions = bench::handlesFor(*organ);
  Progress progress;
  for (auto _ : state)
    benchmark::DoNotOptimize(live::tissueEnergy({organ}, *coordinates::sCelestial(), handles, {}, progress));
}
BENCHMARK(tissueOfAnOrgan)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
} // namespace viscera
