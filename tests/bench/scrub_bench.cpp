#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "label_files.h"
#include "session_fixture.h"
#include "temporary_folder.h"
#include "viscera/document/scan_item.h"
#include "viscera/document/study_item.h"
#include "viscera/medical_io/cine_writer.h"
#include "viscera/presentation/cine_presenter.h"
#include "viscera/presentation/slice_presenter.h"

/// What the timeline costs for each picture of images over time, until it can be drawn: the phase from the
/// ring of decoded ones or from its file, three slices of 400 x 400 pixels, and the contours of an organ in
/// another pose. 25 pictures a second leave 40 ms, 15 leave 66 ms.
namespace viscera {
namespace {

constexpr int kPane = 400;

/// A ball of 30 mm with ten handles, beside images that `open` adds.
struct ScrubbedBall : tests::BoundSession {
  presentation::ViewState view;

  explicit ScrubbedBall(const document::Command& open) { undo.perform(open); }

  /// Another instant, and the organ's pose in it.
  void step(double fraction) {
    view.scan.cine.fraction = fraction;
    Points moved = document.pose().topRows(1);
    moved(0, 2) += std::sin(6.28 * fraction);
    undo.perform(document::moveHandles({document.rig().handles.front().id}, moved));
  }
  std::vector<presentation::SlicePane> panes() const {
    return {{0, kPane, kPane}, {1, kPane, kPane}, {2, kPane, kPane}};
  }
};

/// Eight phases of 512 x 512 x 100 voxels of 16 bits as one NIfTI file (420 MB).
class GatedFile {
public:
  static constexpr int kPhases = 8;

  GatedFile() {
    tests::LabelImage image = tests::emptyLabels({512, 512, 100});
    image.indexToLps.linear() = Vec3(0.4, 0.4, 1).asDiagonal();
    image.indexToLps.translation() = Vec3(-102, -102, -50);
    for (std::size_t v = 0; v < image.voxels.size(); ++v)
      image.voxels[v] = static_cast<std::int16_t>(v * 2654435761U >> 20U & 2047U);
    std::string bytes = tests::niftiFile(image);
    const std::string volume = bytes.substr(bytes.size() - 2 * image.voxels.size());
    tests::putBytes<std::int16_t>(bytes, 40, 4);
    tests::putBytes<std::int16_t>(bytes, 48, kPhases);
    tests::putBytes<float>(bytes, 92, 0.1F);
    bytes[123] = 2 | 8; // mm and seconds
    std::ofstream stream(file(), std::ios::binary);
    stream << bytes;
    for (int phase = 1; phase < kPhases; ++phase)
      stream << volume;
  }
  std::filesystem::path file() const { return folder_ / "gated.nii"; }

  static const GatedFile& only() {
    static const GatedFile gated;
    return gated;
  }

private:
  tests::TemporaryFolder folder_;
};

/// The next phase of the scan; with room for one phase, each is read from its file.
void scrubGatedScan(benchmark::State& state, std::size_t keptBytes) {
  Progress progress;
  const auto file = GatedFile::only().file();
  auto time = medical_io::readScanOverTime(file, {}, progress, {keptBytes});
  document::ScanItem item{"gated", time->volume(0), file, {}, 0};
  item.time = std::make_shared<const medical_io::ScanOverTime>(*std::move(time));
  ScrubbedBall ball(document::openScan(std::move(item)));
  presentation::SlicePresenter slices;
  int picture = 0;
  for (auto _ : state) {
    ball.step(double(++picture % GatedFile::kPhases) / GatedFile::kPhases);
    slices.update({ball.document.state(), ball.live, ball.view}, ball.panes());
    benchmark::DoNotOptimize(slices.picture(0).grey.data());
  }
  state.counters["contours"] = static_cast<double>(slices.contours(0).size());
}
BENCHMARK_CAPTURE(scrubGatedScan, from_the_ring, std::size_t{2} << 30U)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(scrubGatedScan, from_the_file, std::size_t{1})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// Eleven slices of 256 x 208 pixels in 25 phases, six of them a stack, as DICOM files.
class CineFolder {
public:
  static constexpr int kSlices = 11, kStack = 6, kPhases = 25;

  CineFolder() {
    for (int number = 0; number < kSlices; ++number) {
      medical_io::CineSeries series;
      series.patientName = "Bench^Cine";
      series.patientId = "bench";
      series.studyUid = "1.2.3";
      series.seriesUid = "1.2.3." + std::to_string(number + 1);
      series.frameOfReferenceUid = "1.2.4";
      series.number = number + 1;
      series.description = number < kStack ? "cine_sax" : "cine_4CH";
      series.phases = kPhases;
      series.geometry = geometryOf(number);
      std::vector<std::uint16_t> pixels(std::size_t{256} * 208);
      for (int phase = 0; phase < kPhases; ++phase) {
        for (std::size_t p = 0; p < pixels.size(); ++p)
          pixels[p] = static_cast<std::uint16_t>((p + std::size_t(phase) * 977) * 2654435761U >> 20U & 1023U);
        medical_io::writeCinePicture(
            folder_ / (std::to_string(number) + "_" + std::to_string(phase) + ".dcm"), series, phase, pixels);
      }
    }
  }
  std::filesystem::path place() const { return folder_.path(); }

  static const CineFolder& only() {
    static const CineFolder cine;
    return cine;
  }

private:
  static medical_io::CineGeometry geometryOf(int number) {
    medical_io::CineGeometry geometry;
    const double angle = 0.6 * (number - kStack);
    geometry.row = number < kStack ? Vec3(1, 0, 0) : Vec3(std::cos(angle), std::sin(angle), 0);
    geometry.column = number < kStack ? Vec3(0, 1, 0) : Vec3(0, 0, -1);
    geometry.betweenColumns = geometry.betweenRows = 1.4;
    geometry.thickness = 6;
    geometry.columns = 256;
    geometry.rows = 208;
    const Vec3 middle(0, 0, number < kStack ? 10.0 * number - 25 : 0);
    geometry.origin = middle - 0.7 * 255 * geometry.row - 0.7 * 207 * geometry.column;
    return geometry;
  }

  tests::TemporaryFolder folder_;
};

/// The next picture of the study: all eleven slices are decoded, three of them drawn.
void scrubCineStudy(benchmark::State& state) {
  Progress progress;
  document::StudyItem item = document::readStudy(CineFolder::only().place(), progress);
  const auto study = item.study;
  ScrubbedBall ball(document::openStudy(std::move(item)));
  presentation::CinePresenter slices;
  int picture = 0;
  for (auto _ : state) {
    const double fraction = double(++picture % CineFolder::kPhases) / CineFolder::kPhases;
    ball.step(fraction);
    for (const medical_io::CineSlice& slice : study->slices)
      benchmark::DoNotOptimize(slice.image(slice.phaseAt(fraction)));
    slices.update({ball.document.state(), ball.live, ball.view}, ball.panes());
    benchmark::DoNotOptimize(slices.picture(0).grey.data());
  }
  state.counters["contours"] = static_cast<double>(slices.contours(0).size());
}
BENCHMARK(scrubCineStudy)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
} // namespace viscera
