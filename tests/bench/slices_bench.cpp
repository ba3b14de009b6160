#include <cstdint>
#include <vector>

#include <benchmark/benchmark.h>

#include "phantom_scan.h"
#include "shapes.h"
#include "viscera/geometry/plane_cut.h"
#include "viscera/slices/sample_slice.h"

/// What a slice of a scan costs until it is drawn: its samples, its grey levels, the organs' contours.
namespace viscera {
namespace {

using slices::SliceFrame;

medical_io::Scan bigScan() {
  medical_io::Scan scan;
  scan.size = {512, 512, 300};
  scan.indexToLps.linear() = Vec3(0.8, 0.8, 1).asDiagonal();
  std::vector<std::int16_t> samples(scan.voxelCount());
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i] = static_cast<std::int16_t>(i * 2654435761u >> 20 & 2047);
  scan.samples = std::move(samples);
  return scan;
}

SliceFrame frameIn(const medical_io::Scan& scan, int direction, double forward) {
  Vec3 center = scan.indexToLps * Vec3(256, 256, 150);
  center += forward * Vec3::Ones();
  return slices::frameAround(slices::sliceDirections()[std::size_t(direction)], center, 0.8, 512, 512);
}

/// The next slice of 512 x 512 pixels: samples and grey levels.
void scroll(benchmark::State& state, int direction, slices::SampleOptions options) {
  const medical_io::Scan scan = bigScan();
  slices::ValueImage image;
  std::vector<std::uint8_t> grey;
  int step = 0;
  for (auto _ : state) {
    slices::sampleSlice(scan, frameIn(scan, direction, 0.3 * (++step % 100)), options, image);
    slices::greyOf(image, {1024, 2048}, 0, grey, options.threads);
    benchmark::DoNotOptimize(grey.data());
  }
}
BENCHMARK_CAPTURE(scroll, axial, 0, {})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(scroll, coronal, 1, {})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(scroll, sagittal, 2, {})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(scroll, axial_slab_of_10_mm, 0, {.slabMm = 10})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// The same slice as a lattice of rest places bends it; without finding those.
void bend(benchmark::State& state) {
  const medical_io::Scan scan = bigScan();
  const SliceFrame frame = frameIn(scan, 0, 0);
  slices::RestLattice lattice = slices::latticeOver(frame, 8);
  for (Eigen::Index i = 0; i < lattice.rest.rows(); ++i)
    lattice.rest.row(i).array() += 5 * std::sin(0.01 * double(i));
  slices::ValueImage image;
  for (auto _ : state) {
    slices::sampleSlice(scan, frame, {}, image, &lattice);
    benchmark::DoNotOptimize(image.values.data());
  }
}
BENCHMARK(bend)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The contours of 108 balls (884,736 triangles), close to each other as organs are, on three planes.
void contours(benchmark::State& state) {
  std::vector<geometry::TriangleMesh> balls;
  for (int i = 0; i < 108; ++i)
    balls.push_back(tests::sphere(5, 30, Vec3(55.0 * (i % 6), 55.0 * (i / 6 % 6), 55.0 * (i / 36))));
  std::vector<geometry::SurfaceView> surfaces;
  for (const auto& ball : balls)
    surfaces.push_back({&ball.points, &ball.triangles});
  double shift = 0;
  std::size_t lines = 0;
  for (auto _ : state) {
    shift = shift < 20 ? shift + 0.37 : 0;
    const Vec3 place(100 + shift, 100 + shift, 50 + shift);
    const auto cuts = geometry::cutSurfaces(
        surfaces, {{place, Vec3::UnitX()}, {place, Vec3::UnitY()}, {place, Vec3::UnitZ()}});
    lines = 0;
    for (const auto& surface : cuts)
      for (const auto& cut : surface)
        lines += cut.lines();
  }
  state.counters["lines"] = static_cast<double>(lines);
}
BENCHMARK(contours)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
} // namespace viscera
