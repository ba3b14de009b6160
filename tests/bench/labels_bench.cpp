#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "build_paths.h"
#include "label_files.h"
#include "temporary_folder.h"
#include "viscera/core/progress.h"
#include "viscera/document/import_draft.h"
#include "viscera/document/open_files.h"
#include "viscera/medical_io/image_file.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/label_surfaces.h"

namespace viscera {
namespace {

/// Twelve balls of 15 to 37 voxels in a grid of 3.6 million, somewhat flat as slices of a scanner are.
tests::LabelImage phantom() {
  tests::LabelImage image = tests::emptyLabels({180, 160, 125});
  image.indexToLps.linear() = Vec3(1.5, 1.5, 2).asDiagonal();
  for (int ball = 0; ball < 12; ++ball)
    tests::addBall(image, Vec3(25 + 43 * (ball % 4), 30 + 48 * (ball / 4), 30 + 7 * (ball % 9)),
                   15 + 2 * ball, static_cast<std::int16_t>(ball + 1));
  return image;
}

/// The atlas beside the project where it is, else the phantom.
class LabelFile {
public:
  LabelFile() : file_(std::filesystem::path(VISCERA_SHARED_ORGANS) / "abdomen_seg.nrrd") {
    if (!std::filesystem::exists(file_))
      file_ = folder_.put("phantom.nrrd", tests::nrrdFile(phantom()));
  }
  const std::filesystem::path& path() const { return file_; }

private:
  tests::TemporaryFolder folder_;
  std::filesystem::path file_;
};

medical_io::LabelMap read(const LabelFile& file) {
  Progress progress;
  return medical_io::readLabelMap(file.path(), progress);
}

void describe(benchmark::State& state, const LabelFile& file, const medical_io::LabelMap& map) {
  state.SetLabel(file.path().filename().string());
  state.counters["voxels"] = static_cast<double>(map.voxelCount());
  state.counters["labels"] = static_cast<double>(map.segments.size());
}

void readLabels(benchmark::State& state) {
  const LabelFile file;
  medical_io::LabelMap map;
  for (auto _ : state)
    map = read(file);
  describe(state, file, map);
}

/// What a user waits for who opens all organs of a label map, at the standard 20,000 triangles each.
void surfacesOfAllLabels(benchmark::State& state) {
  const LabelFile file;
  const medical_io::LabelMap map = read(file);
  const Threads threads{static_cast<int>(state.range(0))};
  Eigen::Index triangles = 0;
  for (auto _ : state) {
    Progress progress;
    triangles = 0;
    for (const auto& surface : medical_io::labelSurfaces(map, {}, progress, threads))
      triangles += surface.mesh.triangles.rows();
  }
  describe(state, file, map);
  state.counters["triangles"] = static_cast<double>(triangles);
}

/// Forty lobed bodies in 512 x 512 x 600 voxels, as large as a scan of the whole trunk.
medical_io::LabelMap largeMap() {
  medical_io::LabelMap map;
  map.size = {512, 512, 600};
  map.indexToLps.linear() = Vec3(0.8, 0.8, 1).asDiagonal();
  std::vector<std::uint8_t> voxels(map.voxelCount());
  for (int body = 0; body < 40; ++body) {
    medical_io::Segment segment;
    segment.label = body + 1;
    segment.name = "Body " + std::to_string(body + 1);
    const Eigen::Vector3i middle(64 + 128 * (body % 4), 64 + 128 * (body / 4 % 4), 100 + 200 * (body / 16));
    const double radius = 35 + body % 7 * 3;
    for (std::size_t d = 0; d < 3; ++d) {
      const int at = middle[static_cast<Eigen::Index>(d)];
      segment.low[d] = std::max(0, at - 60);
      segment.high[d] = std::min(map.size[d] - 1, at + 60);
    }
    for (int k = segment.low[2]; k <= segment.high[2]; ++k)
      for (int j = segment.low[1]; j <= segment.high[1]; ++j)
        for (int i = segment.low[0]; i <= segment.high[0]; ++i) {
          const Vec3 from = Vec3(i, j, k) - middle.cast<double>();
          const double lobes =
              1 + 0.1 * std::sin(0.12 * from.x()) * std::cos(0.09 * from.y() + 0.05 * from.z());
          if (from.norm() < radius * lobes) {
            voxels[map.indexOf(i, j, k)] = static_cast<std::uint8_t>(body + 1);
            ++segment.voxels;
          }
        }
    map.segments.push_back(segment);
  }
  map.layers.emplace_back(std::move(voxels));
  return map;
}

/// The most memory of this process in MB, since `forgetPeak` where the system can forget it.
double peakMb() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:"))
      return std::stod(line.substr(6)) / 1024;
  return 0;
}

void forgetPeak() {
  std::ofstream("/proc/self/clear_refs") << 5;
}

/// What a user waits for who opens such a file: bytes, surfaces, checks.
void openLargeMap(benchmark::State& state) {
  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder / "large.nrrd";
  medical_io::writeLabelMap(file, largeMap());
  forgetPeak();
  std::size_t organs = 0;
  for (auto _ : state) {
    Progress progress;
    organs = document::draftOf(document::openPatient({file}, progress), progress).files.organs.size();
  }
  state.counters["organs"] = static_cast<double>(organs);
  state.counters["peakMB"] = peakMb();
}

} // namespace

BENCHMARK(openLargeMap)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
BENCHMARK(readLabels)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
BENCHMARK(surfacesOfAllLabels)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

} // namespace viscera
