#include <memory>
#include <utility>

#include <benchmark/benchmark.h>

#include "bench_scenes.h"
#include "viscera/coordinates/systems.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/deformation/deformer.h"
#include "viscera/deformation/pose_together.h"

namespace viscera::deformation {
namespace {

/// 172,974 vertices bound to 30 handles.
Deformer largeDeformer(int threads) {
  const auto organ = std::make_shared<const geometry::TriangleMesh>(bench::largeBlob());
  coordinates::HandleSet handles;
  handles.positions = bench::handlesFor(*organ);
  Progress progress;
  const auto binding =
      bindOrgan(*coordinates::sCelestial(), handles, organ->points, {{}, {threads}}, progress);
  return Deformer(organ, binding, handles.positions, {threads});
}

/// One step of dragging a handle, with all that a frame shows. Argument: threads.
void drag(benchmark::State& state) {
  Deformer deformer = largeDeformer(static_cast<int>(state.range(0)));
  const Vec3 start = deformer.restHandles().row(12).transpose();
  int step = 0;
  for (auto _ : state) {
    deformer.moveHandle(12, start + Vec3(0.1 * (++step % 50), 0, 0));
    benchmark::DoNotOptimize(deformer.normals().data());
    benchmark::DoNotOptimize(deformer.volumeMm3());
    benchmark::DoNotOptimize(deformer.volumeGradient().data());
  }
}
BENCHMARK(drag)->Arg(1)->Arg(2)->ArgName("threads")->Unit(benchmark::kMillisecond)->UseRealTime();

/// The parts of it: moving the points (0), normals (1), volume (2), the volume's gradient (3).
void dragPart(benchmark::State& state) {
  Deformer deformer = largeDeformer(static_cast<int>(state.range(0)));
  const Vec3 start = deformer.restHandles().row(12).transpose();
  const long part = state.range(1);
  int step = 0;
  for (auto _ : state) {
    const Vec3 to = start + Vec3(0.1 * (++step % 50), 0, 0);
    if (part > 0)
      state.PauseTiming();
    deformer.moveHandle(12, to);
    if (part > 0)
      state.ResumeTiming();
    if (part == 1)
      benchmark::DoNotOptimize(deformer.normals().data());
    if (part == 2)
      benchmark::DoNotOptimize(deformer.volumeMm3());
    if (part == 3)
      benchmark::DoNotOptimize(deformer.volumeGradient().data());
  }
}
BENCHMARK(dragPart)
    ->ArgsProduct({{2}, {0, 1, 2, 3}})
    ->ArgNames({"threads", "part"})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// 95 organs of 5,002 vertices, as an atlas has them, each bound by itself to the same 30 handles.
class Atlas {
public:
  explicit Atlas(Threads threads) : threads_(threads) {
    const auto organ = std::make_shared<const geometry::TriangleMesh>(bench::blob(50, 100));
    handles_.positions = bench::handlesFor(*organ);
    for (int k = 0; k < 95; ++k) {
      Progress progress;
      organs_.emplace_back(
          organ, bindOrgan(*coordinates::sCelestial(), handles_, organ->points, {{}, threads}, progress),
          handles_.positions, threads);
    }
    for (Deformer& bound : organs_)
      all_.push_back(&bound);
  }

  /// The next pose of all handles, or of handle 12 alone, and all volumes: in one loop, or in two an organ.
  void step(bool oneHandle, bool together) {
    Points pose = handles_.positions;
    if (oneHandle)
      pose(12, 0) += 0.1 * (++step_ % 50);
    else
      pose.array() += 0.1 * (++step_ % 50);
    if (together) {
      const auto shared = std::make_shared<const Points>(std::move(pose));
      std::vector<NewPose> poses;
      for (Deformer* organ : all_)
        poses.push_back({organ, shared, oneHandle ? std::vector<int>{12} : std::vector<int>{}});
      poseTogether(poses, threads_);
      benchmark::DoNotOptimize(volumesTogether(all_, threads_).data());
      return;
    }
    for (Deformer& organ : organs_) {
      oneHandle ? organ.moveHandle(12, pose.row(12).transpose()) : organ.setPose(pose);
      benchmark::DoNotOptimize(organ.volumeMm3());
    }
  }

private:
  Threads threads_;
  coordinates::HandleSet handles_;
  std::vector<Deformer> organs_;
  std::vector<Deformer*> all_;
  int step_ = 0;
};

/// 95 organs posed and measured. `together` 0: by loops of each organ; 1: by loops over all of them.
void poseAtlas(benchmark::State& state) {
  Atlas atlas({static_cast<int>(state.range(0))});
  for (auto _ : state)
    atlas.step(state.range(1) != 0, state.range(2) != 0);
}
BENCHMARK(poseAtlas)
    ->ArgsProduct({{1, 2}, {0, 1}, {0, 1}})
    ->ArgNames({"threads", "oneHandle", "together"})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// Automatic handles on a large organ.
void placeThirtyHandles(benchmark::State& state) {
  const geometry::TriangleMesh organ = bench::largeBlob();
  for (auto _ : state)
    benchmark::DoNotOptimize(placeHandles(organ));
}
BENCHMARK(placeThirtyHandles)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
} // namespace viscera::deformation
