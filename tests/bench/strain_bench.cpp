#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include <benchmark/benchmark.h>

#include "thick_cylinder.h"
#include "viscera/coordinates/systems.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/deformation/witness_gradients.h"
#include "viscera/strain/heart_gauge.h"

namespace viscera {
namespace {

/// A thick-walled cylinder with about 13,000 witness points and 120 handles, which beats in 25 phases.
struct BeatingCylinder {
  static constexpr int kPhases = 25;

  tests::ThickCylinder tube;
  deformation::WitnessMesh mesh = tests::tubeWall(tube, 64, 8, 31);
  geometry::TriangleMesh inner = tests::closedTube(tube.inner, 0, tube.length, 64, 31);
  geometry::TriangleMesh outer = tests::closedTube(tube.outer, 0, tube.length, 64, 31);
  strain::FoundAxes axes;
  std::shared_ptr<const strain::WallPoints> points;
  std::shared_ptr<const deformation::WitnessGradients> gradients;
  std::vector<Points> poses;
  std::optional<strain::HeartGauge> gauge;
  strain::HeartPhases phases;

  BeatingCylinder() : axes(foundAxes(inner, tube)) {
    Progress progress;
    points = std::make_shared<const strain::WallPoints>(
        strain::wallPoints(mesh, {&inner, &outer, nullptr}, axes.axes, axes.cap, progress));
    coordinates::HandleSet handles;
    handles.positions = deformation::placeHandles(outer, {.count = 120});
    Points places(points->count(), 3);
    for (Eigen::Index i = 0; i < places.rows(); ++i)
      places.row(i) = mesh.points.row(points->rows[static_cast<std::size_t>(i)]);
    for (const auto& system : coordinates::builtInSystems())
      if (system->id() == "s-celestial")
        gradients = deformation::bindWitnesses(*system, handles, places, {}, progress);
    gauge.emplace(strain::HeartSurfaces{.left = strain::HeartSurface{"LV", inner.triangles, inner.points},
                                        .outer = strain::HeartSurface{"EPI", outer.triangles, outer.points}},
                  axes, points, std::vector<strain::ListedContour>());
    for (int phase = 0; phase < kPhases; ++phase) {
      const double part = std::sin(std::numbers::pi * phase / kPhases);
      const tests::CylinderMotion motion{tube, 20 - 6 * part, 1 - 0.15 * part, 0.003 * part};
      poses.push_back(motion(handles.positions));
      phases.left.push_back(motion(inner.points));
      phases.outer.push_back(motion(outer.points));
      phases.seconds.push_back(0.033 * phase);
    }
    phases.gradientsAt = [this](std::size_t phase, std::vector<Eigen::Matrix3d>& result, Threads threads) {
      gradients->deformationGradients(poses[phase], result, threads);
    };
  }
  BeatingCylinder(const BeatingCylinder&) = delete;
  BeatingCylinder& operator=(const BeatingCylinder&) = delete;

private:
  static strain::FoundAxes foundAxes(const geometry::TriangleMesh& inner, const tests::ThickCylinder& tube) {
    strain::AxisLandmarks given;
    given.base = Vec3::Zero();
    given.apex = Vec3(0, 0, tube.length);
    given.insertion = Vec3(20, 0, 10);
    return strain::findAxes(inner, nullptr, given);
  }
};

/// All phases: at most a second.
void strainOfABeat(benchmark::State& state) {
  const BeatingCylinder beating;
  Progress progress;
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(beating.gauge->read(beating.phases, progress));
  state.counters["witnesses"] = static_cast<double>(beating.points->count());
  state.counters["phases"] = BeatingCylinder::kPhases;
}
BENCHMARK(strainOfABeat)->Unit(benchmark::kMillisecond);

/// While a handle is dragged: one pose against rest.
void strainOfAPose(benchmark::State& state) {
  BeatingCylinder beating;
  const std::vector<std::size_t> kept = {0, BeatingCylinder::kPhases / 2};
  strain::HeartPhases& phases = beating.phases;
  for (auto* surface : {&phases.left, &phases.outer})
    *surface = {(*surface)[kept[0]], (*surface)[kept[1]]};
  phases.left[0] = beating.gauge->surfaces().left->rest;
  phases.outer[0] = beating.gauge->surfaces().outer->rest;
  beating.poses = {beating.poses[kept[0]], beating.poses[kept[1]]};
  phases.seconds = {0, 1};
  Progress progress;
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(beating.gauge->read(beating.phases, progress));
}
BENCHMARK(strainOfAPose)->Unit(benchmark::kMillisecond);

/// The stress map of the same points, which a drag has to keep up with, too.
void stressOfAPose(benchmark::State& state) {
  const BeatingCylinder beating;
  deformation::StressMap map;
  for ([[maybe_unused]] auto _ : state) {
    beating.gradients->evaluate(beating.poses[BeatingCylinder::kPhases / 2], map);
    benchmark::DoNotOptimize(map.rotationalStress.data());
  }
}
BENCHMARK(stressOfAPose)->Unit(benchmark::kMillisecond);

/// Once for an organ: the layers of the wall.
void layersOfTheWall(benchmark::State& state) {
  const BeatingCylinder beating;
  Progress progress;
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(strain::wallPoints(beating.mesh, {&beating.inner, &beating.outer, nullptr},
                                                beating.axes.axes, beating.axes.cap, progress));
}
BENCHMARK(layersOfTheWall)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace viscera
