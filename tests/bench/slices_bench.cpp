#include <cstdint>
#include <vector>

#include <benchmark/benchmark.h>

#include "clouds.h"
#include "shapes.h"
#include "viscera/coordinates/systems.h"
#include "viscera/deformation/inverse_map.h"
#include "viscera/geometry/plane_cut.h"
#include "viscera/medical_io/sample_slice.h"

/// What a slice of a scan costs until it is drawn: its samples, its grey levels, the organs' contours.
namespace viscera {
namespace {

using medical_io::SliceFrame;

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
  return medical_io::frameAround(medical_io::sliceDirections()[std::size_t(direction)], center, 0.8, 512,
                                 512);
}

/// The next slice of 512 x 512 pixels: samples and grey levels.
void scroll(benchmark::State& state, int direction, medical_io::SampleOptions options) {
  const medical_io::Scan scan = bigScan();
  medical_io::ValueImage image;
  std::vector<std::uint8_t> grey;
  int step = 0;
  for (auto _ : state) {
    medical_io::sampleSlice(scan, frameIn(scan, direction, 0.3 * (++step % 100)), options, image);
    medical_io::greyOf(image, {1024, 2048}, 0, grey, options.threads);
    benchmark::DoNotOptimize(grey.data());
  }
}
BENCHMARK_CAPTURE(scroll, axial, 0, {})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(scroll, coronal, 1, {})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(scroll, sagittal, 2, {})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(scroll, axial_slab_of_10_mm, 0, {.slabMm = 10})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// The same of a scan that lies askew, as an oblique MR does.
void scrollOblique(benchmark::State& state, medical_io::SampleOptions options) {
  medical_io::Scan scan = bigScan();
  scan.indexToLps = Eigen::AngleAxisd(0.2, Vec3(1, 2, 3).normalized()) * scan.indexToLps;
  medical_io::ValueImage image;
  std::vector<std::uint8_t> grey;
  int step = 0;
  for (auto _ : state) {
    medical_io::sampleSlice(scan, frameIn(scan, 0, 0.3 * (++step % 100)), options, image);
    medical_io::greyOf(image, {1024, 2048}, 0, grey, options.threads);
    benchmark::DoNotOptimize(grey.data());
  }
}
BENCHMARK_CAPTURE(scrollOblique, thin, {})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(scrollOblique, slab_of_10_mm, {.slabMm = 10})->Unit(benchmark::kMillisecond)->UseRealTime();

/// What a drag does for a slice of 512 x 512 that shows the bent scan, from the pose to the grey levels: 30
/// handles around an organ of 200 mm, four of which are dragged by some 25 mm.
void bend(benchmark::State& state) {
  const medical_io::Scan scan = bigScan();
  const SliceFrame frame = frameIn(scan, 0, 0);
  const Vec3 middle = frame.at(256, 256);
  const auto celestial = coordinates::sCelestial();
  const coordinates::CoordinateSystem& system = *celestial;
  const coordinates::HandleSet handles{tests::onSphere(30, 110, middle), {}, {}};
  const auto posed = [&](double mm) {
    Points pose = handles.positions;
    for (int handle = 0; handle < 4; ++handle)
      pose.row(handle) += mm / 110 * (pose.row(handle) - middle.transpose());
    return pose;
  };
  Progress progress;
  deformation::InverseMap map(system, handles, posed(25), {}, {}, progress);
  const deformation::SamplePlane plane{frame.corner, frame.right, frame.up, frame.width, frame.height};
  deformation::RestPoints rest;
  medical_io::ValueImage image;
  std::vector<std::uint8_t> grey;
  double mm = 20;
  for (auto _ : state) {
    mm = mm < 25 ? mm + 0.5 : 20;
    map.setPose(posed(mm));
    map.restPlane(plane, rest);
    map.refinePlane(system, plane, {.toleranceMm = 0.03}, rest, progress);
    medical_io::sampleSlice(scan, frame, {}, image, &rest.points);
    medical_io::greyOf(image, {1024, 2048}, 0, grey);
    benchmark::DoNotOptimize(grey.data());
  }
  Points samples(plane.columns * plane.rows, 3);
  for (Eigen::Index i = 0; i < samples.rows(); ++i)
    samples.row(i) = plane.at(i % plane.columns, i / plane.columns).transpose();
  state.counters["errorMm"] = map.residualMm(system, samples, rest, progress);
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
