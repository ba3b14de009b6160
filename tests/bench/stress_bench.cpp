#include <algorithm>
#include <cmath>
#include <memory>

#include <benchmark/benchmark.h>

#include "tetrahedra.h"
#include "viscera/coordinates/systems.h"
#include "viscera/deformation/witness_gradients.h"
#include "viscera/live/stress_quantity.h"
#include "viscera/scene/tissue_actor.h"

namespace viscera::scene {
namespace {

/// The corners of a box and handles spread over a ball around the solid.
Points handlesAround(int count) {
  Points points(count, 3);
  for (int i = 0; i < count; ++i) {
    const double z = 1 - 2 * (i + 0.5) / count, around = 2.399963 * i, r = std::sqrt(1 - z * z);
    points.row(i) = 90 * Eigen::RowVector3d(r * std::cos(around), r * std::sin(around), z);
  }
  return points;
}

/// Everything that a new pose costs Stress mode but the drawing: the map, the numbers to show, their summary,
/// and the tissue cut open. 26^3 cells: 19,683 witnesses, 105,456 tetrahedra; 30 handles.
void stressFrame(benchmark::State& state) {
  const tests::Solid solid = tests::solidBox(26, 40);
  const auto systems = coordinates::builtInSystems();
  const auto system =
      *std::find_if(systems.begin(), systems.end(), [](const auto& s) { return s->id() == "s-celestial"; });
  coordinates::HandleSet handles;
  handles.positions = handlesAround(30);
  Progress progress;
  const auto gradients = deformation::bindWitnesses(*system, handles, solid.points, {}, progress);
  const auto binding = system->bind(handles, solid.points, {}, progress);
  auto points = std::make_shared<Points>(solid.points);
  auto values = std::make_shared<Values>(solid.points.rows());
  TissueActor tissue(std::make_shared<const Tetrahedra>(solid.tetrahedra), points);
  if (state.range(0) == 1)
    tissue.setCut({Vec3(0, 1, 0), Vec3::UnitY()}, CutStyle::smooth);
  if (state.range(0) == 2)
    tissue.setShownRange({5, 90});
  tissue.setColors(viridis(), {0, 20});
  Points pose = handles.positions;
  deformation::StressMap map;
  int frame = 0;
  for (auto _ : state) {
    pose(0, 0) = handles.positions(0, 0) + 20 * std::sin(0.1 * ++frame);
    gradients->evaluate(pose, map);
    binding->deform(pose, *points);
    benchmark::DoNotOptimize(deformation::statisticsOf(map, map.rotationalStress.size()));
    live::quantityOf(map, live::StressQuantity::rotationalStress, *values);
    benchmark::DoNotOptimize(live::summaryOf(*values, values->size()));
    tissue.setPoints(points);
    tissue.setValues(values);
    tissue.update();
  }
  state.counters["points"] = double(solid.points.rows());
  state.counters["tetrahedra"] = double(solid.tetrahedra.rows());
  state.SetLabel(state.range(0) == 0 ? "whole" : state.range(0) == 1 ? "cut open" : "beyond a limit");
}
BENCHMARK(stressFrame)->DenseRange(0, 2)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
} // namespace viscera::scene
