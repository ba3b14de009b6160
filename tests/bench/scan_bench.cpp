#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "clouds.h"
#include "dicom_slices.h"
#include "temporary_folder.h"
#include "viscera/coordinates/systems.h"
#include "viscera/deformation/inverse_map.h"
#include "viscera/medical_io/scan.h"

namespace viscera {
namespace {

constexpr int kSide = 512, kSlices = 600;

/// A scan of 512 x 512 x 600 voxels of 16 bits, once for all runs: as NIfTI and as DICOM.
class LargeScan {
public:
  LargeScan() {
    tests::LabelImage image = tests::emptyLabels({kSide, kSide, kSlices});
    image.indexToLps.linear() = Vec3(0.75, 0.75, 1).asDiagonal();
    unsigned state = 1;
    for (std::int16_t& voxel : image.voxels) {
      state = state * 1664525U + 1013904223U;
      voxel = static_cast<std::int16_t>((state >> 20U) % 2000U - 1000U);
    }
    folder_.put("ct.nii", tests::niftiFile(image));
    std::filesystem::create_directory(folder_ / "dicom");
    for (int k = 0; k < kSlices; ++k)
      folder_.put("dicom/" + std::to_string(k) + ".dcm", tests::dicomBytes(tests::dicomSlice(image, k)));
  }
  std::filesystem::path nifti() const { return folder_ / "ct.nii"; }
  std::filesystem::path dicom() const { return folder_ / "dicom"; }

  static const LargeScan& only() {
    static const LargeScan scan;
    return scan;
  }

private:
  tests::TemporaryFolder folder_;
};

/// The bytes of a file into memory of its own, and nothing else.
void takeBytes(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::vector<char> bytes(std::filesystem::file_size(file));
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  benchmark::DoNotOptimize(bytes.data());
}

void bytesOfNifti(benchmark::State& state) {
  const auto file = LargeScan::only().nifti();
  for (auto _ : state)
    takeBytes(file);
}

void openNifti(benchmark::State& state) {
  const auto file = LargeScan::only().nifti();
  for (auto _ : state) {
    Progress progress;
    benchmark::DoNotOptimize(medical_io::readScan(file, {}, progress));
  }
}

void bytesOfDicom(benchmark::State& state) {
  const auto folder = LargeScan::only().dicom();
  for (auto _ : state) {
    std::vector<char> all(std::size_t{kSide} * kSide * kSlices * 2);
    std::size_t at = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      std::ifstream stream(entry.path(), std::ios::binary);
      stream.read(all.data() + at, std::streamsize{kSide} * kSide * 2);
      at += std::size_t{kSide} * kSide * 2;
    }
    benchmark::DoNotOptimize(all.data());
  }
}

void openDicom(benchmark::State& state) {
  const auto folder = LargeScan::only().dicom();
  for (auto _ : state) {
    Progress progress;
    benchmark::DoNotOptimize(medical_io::readScan(folder, {}, progress));
  }
}

/// 30 handles around an organ of 200 mm, of which a few are dragged by 25 mm.
struct DraggedRig {
  coordinates::HandleSet handles{tests::onSphere(30, 110), {}, {}};
  Points pose = handles.positions;

  explicit DraggedRig(double mm) {
    for (int handle = 0; handle < 4; ++handle)
      pose.row(handle) *= 1 + mm / 110;
  }
};

/// Once for a rig: what a user waits for before the scan bends along.
void bindTheSpaceBetweenHandles(benchmark::State& state) {
  const DraggedRig rig(25);
  for (auto _ : state) {
    Progress progress;
    const deformation::InverseMap map(*coordinates::sCelestial(), rig.handles, rig.pose, {}, {}, progress);
    state.counters["errorMm"] = map.errorMm();
    state.counters["spacingMm"] = map.spacingMm();
  }
}

/// What a drag does for each slice that is shown: the pose, and 512 x 512 places at rest.
void warpedSlice(benchmark::State& state) {
  const DraggedRig first(20), second(25);
  Progress progress;
  deformation::InverseMap map(*coordinates::sCelestial(), first.handles, first.pose, {}, {}, progress);
  const deformation::SamplePlane plane{{-200, -200, 10}, {0.78, 0, 0}, {0, 0.78, 0}, kSide, kSide};
  deformation::RestPoints rest;
  bool other = false;
  for (auto _ : state) {
    other = !other;
    map.setPose(other ? second.pose : first.pose);
    map.restPlane(plane, rest);
  }
  std::size_t moved = 0;
  for (const auto one : rest.states)
    moved += one != deformation::RestState::still ? 1U : 0U;
  state.counters["moved"] = static_cast<double>(moved);
}

void poseOfTheSpace(benchmark::State& state) {
  const DraggedRig first(20), second(25);
  Progress progress;
  deformation::InverseMap map(*coordinates::sCelestial(), first.handles, first.pose, {}, {}, progress);
  bool other = false;
  for (auto _ : state) {
    other = !other;
    map.setPose(other ? second.pose : first.pose);
  }
}

BENCHMARK(bytesOfNifti)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(openNifti)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(bytesOfDicom)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(openDicom)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(bindTheSpaceBetweenHandles)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(poseOfTheSpace)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(warpedSlice)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
} // namespace viscera
