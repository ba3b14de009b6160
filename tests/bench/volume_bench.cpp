#include <map>
#include <memory>

#include <benchmark/benchmark.h>

#include "bench_scenes.h"
#include "sized_surface.h"
#include "viscera/coordinates/systems.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/deformation/deformer.h"
#include "viscera/deformation/volume_form.h"
#include "viscera/geometry/volume.h"
#include "viscera/sample_organs/sample_organ.h"

/// Table 5.2 of the thesis on the sample heart: volume, and its gradient with respect to 30 handles, for
/// surfaces of the thesis's numbers of vertices.
namespace viscera::deformation {
namespace {

/// The sample heart with so many vertices, bound to 30 handles and pulled out of rest.
struct BoundHeart {
  std::shared_ptr<const geometry::TriangleMesh> rest;
  std::shared_ptr<const coordinates::Binding> binding;
  geometry::VertexTriangles around;
  Points pose;
  Points points;
};

BoundHeart makeHeart(Eigen::Index vertices) {
  Progress progress;
  const auto organ = sample_organs::sampleOrgan(sample_organs::standardLibrary(), "heart",
                                                sample_organs::Resolution::high, progress);
  BoundHeart heart;
  heart.rest =
      std::make_shared<geometry::TriangleMesh>(bench::withVertices(*organ.surfaces.front().mesh, vertices));
  coordinates::HandleSet handles;
  handles.positions = bench::handlesFor(*heart.rest);
  heart.binding = bindOrgan(*coordinates::sCelestial(), handles, heart.rest->points, {}, progress);
  heart.around = geometry::vertexTriangles(heart.rest->points.rows(), heart.rest->triangles);
  heart.pose = handles.positions;
  heart.pose.row(12) += Eigen::RowVector3d(9, -4, 6);
  heart.binding->deform(heart.pose, heart.points);
  return heart;
}

/// Made once a size: the benchmarks run several times.
const BoundHeart& heartOf(Eigen::Index vertices) {
  static std::map<Eigen::Index, BoundHeart> made;
  const auto found = made.find(vertices);
  return found != made.end() ? found->second : made.emplace(vertices, makeHeart(vertices)).first->second;
}

void countTriangles(benchmark::State& state, const BoundHeart& heart) {
  const auto triangles = static_cast<double>(heart.rest->triangles.rows());
  state.counters["triangles"] = triangles;
  state.counters["s_per_triangle"] = benchmark::Counter(
      triangles, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void table52Volume(benchmark::State& state) {
  const BoundHeart& heart = heartOf(state.range(0));
  const Threads threads{static_cast<int>(state.range(1))};
  for (auto _ : state)
    benchmark::DoNotOptimize(geometry::volume(heart.points, heart.rest->triangles, threads));
  countTriangles(state, heart);
}

void table52Gradient(benchmark::State& state) {
  const BoundHeart& heart = heartOf(state.range(0));
  const Threads threads{static_cast<int>(state.range(1))};
  Points ofPoints, ofHandles;
  for (auto _ : state) {
    geometry::volumeGradient(heart.points, heart.rest->triangles, heart.around, ofPoints, threads);
    heart.binding->pullBack(heart.pose, ofPoints, ofHandles, threads);
    benchmark::DoNotOptimize(ofHandles.data());
  }
  countTriangles(state, heart);
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgsProduct({{530, 2868, 35947, 70302, bench::kMostVertices}, {1, 2}})
      ->ArgNames({"vertices", "threads"})
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}
BENCHMARK(table52Volume)->Apply(sizes);
BENCHMARK(table52Gradient)->Apply(sizes);

/// The same by the form of the handles alone: making it, then volume and gradient in a new pose.
void makeVolumeForm(benchmark::State& state) {
  const BoundHeart& heart = heartOf(state.range(0));
  for (auto _ : state)
    benchmark::DoNotOptimize(VolumeForm::of(*heart.rest, *heart.binding, {static_cast<int>(state.range(1))}));
}
BENCHMARK(makeVolumeForm)->Apply(sizes);

void volumeAndGradientByForm(benchmark::State& state) {
  const BoundHeart& heart = heartOf(state.range(0));
  const auto form = VolumeForm::of(*heart.rest, *heart.binding);
  Points gradient;
  for (auto _ : state) {
    benchmark::DoNotOptimize(form->volume(heart.pose));
    form->gradient(heart.pose, gradient);
    benchmark::DoNotOptimize(gradient.data());
  }
}
BENCHMARK(volumeAndGradientByForm)
    ->Arg(172974)
    ->ArgName("vertices")
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime();

} // namespace
} // namespace viscera::deformation
