#include <filesystem>
#include <string>

#include <benchmark/benchmark.h>

#include "build_paths.h"
#include "label_files.h"
#include "temporary_folder.h"
#include "viscera/core/progress.h"
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

} // namespace

BENCHMARK(readLabels)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
BENCHMARK(surfacesOfAllLabels)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

} // namespace viscera
