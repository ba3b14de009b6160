#include <cmath>

#include <benchmark/benchmark.h>

#include "shapes.h"
#include "view_fixture.h"

namespace viscera::scene {
namespace {

std::shared_ptr<const geometry::TriangleMesh> ball(int levels) {
  return std::make_shared<const geometry::TriangleMesh>(tests::sphere(levels, 50));
}

/// Handles spread over a ball a little larger than the organ.
Points spiral(int count) {
  Points points(count, 3);
  for (int i = 0; i < count; ++i) {
    const double z = 1 - 2 * (i + 0.5) / count, around = 2.399963 * i, r = std::sqrt(1 - z * z);
    points.row(i) = 54 * Eigen::RowVector3d(r * std::cos(around), r * std::sin(around), z);
  }
  return points;
}

/// What a frame of a deformation costs beside posing and drawing: normals, and telling VTK.
void pointsChanged(benchmark::State& state) {
  const auto mesh = ball(int(state.range(0)));
  OrganActor organ(mesh);
  for (auto _ : state)
    organ.pointsChanged();
  state.counters["vertices"] = double(mesh->points.rows());
}
BENCHMARK(pointsChanged)->Arg(6)->Arg(7)->Unit(benchmark::kMillisecond)->UseRealTime();

/// A mouse move where no handle is: projecting all of them.
void hoverBesideHandles(benchmark::State& state) {
  tests::ViewInWindow window(1200, 800);
  window.view.add(std::make_shared<OrganActor>(ball(6)));
  window.view.handles()->SetPositions(spiral(int(state.range(0))));
  window.view.lookFrom(StandardView::anterior);
  window.render();
  tests::Mouse mouse(window.surface.interactor());
  int i = 0;
  for (auto _ : state)
    mouse.move(3 + ++i % 5, 4);
}
BENCHMARK(hoverBesideHandles)->Arg(30)->Arg(200)->Unit(benchmark::kMicrosecond)->UseRealTime();

/// Asking what is under a cursor that is on a handle: also whether the organ hides it.
void pickHandle(benchmark::State& state) {
  tests::ViewInWindow window(1200, 800);
  window.view.add(std::make_shared<OrganActor>(ball(int(state.range(0)))));
  window.view.handles()->SetPositions(spiral(200));
  window.view.lookFrom(StandardView::anterior);
  window.render();
  const auto at = window.display(window.view.handles()->GetPosition(100));
  for (auto _ : state)
    benchmark::DoNotOptimize(window.view.handles()->PickHandle(int(at[0]), int(at[1])));
}
BENCHMARK(pickHandle)->Arg(6)->Arg(7)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Whole frames, drawn and waited for: while something moves (1) or with smooth edges (0).
void frame(benchmark::State& state) {
  tests::ViewInWindow window(1200, 800);
  auto organ = std::make_shared<OrganActor>(ball(int(state.range(0))));
  window.view.add(organ);
  window.view.handles()->SetPositions(spiral(30));
  window.view.lookFrom(StandardView::anterior);
  window.view.setMoving(state.range(1) != 0);
  window.render();
  for (auto _ : state) {
    organ->pointsChanged();
    window.render();
    window.surface.window()->WaitForCompletion();
  }
}
BENCHMARK(frame)->Args({6, 1})->Args({6, 0})->Args({7, 1})->Unit(benchmark::kMillisecond)->UseRealTime();

/// The same of a wall that one sees through with two cavities in it, as the beating heart is shown.
void translucentFrame(benchmark::State& state) {
  tests::ViewInWindow window(1200, 800);
  auto wall = std::make_shared<OrganActor>(ball(6));
  wall->setOpacity(0.45);
  window.view.add(wall);
  for (const double side : {-1, 1}) {
    auto cavity = tests::sphere(5, 18);
    cavity.points.col(0).array() += 22 * side;
    window.view.add(std::make_shared<OrganActor>(std::make_shared<const geometry::TriangleMesh>(cavity)));
  }
  window.view.lookFrom(StandardView::anterior);
  window.view.setMoving(state.range(0) != 0);
  window.render();
  for (auto _ : state) {
    wall->pointsChanged();
    window.render();
    window.surface.window()->WaitForCompletion();
  }
}
BENCHMARK(translucentFrame)->Arg(1)->Arg(0)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
} // namespace viscera::scene
