#include <algorithm>
#include <variant>

#include "beating_labels.h"
#include "dicom_slices.h"
#include "fuzz_target.h"
#include "good_files.h"
#include "label_files.h"
#include "packed_bytes.h"
#include "packed_dicom.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/label_series.h"
#include "viscera/medical_io/scan.h"

/// Label maps, their series, and scans.
namespace viscera::fuzz {
namespace {

const std::vector<std::string> kImageEndings = {".nii", ".nii.gz", ".nrrd", ".seg.nrrd",
                                                ".mha", ".mhd",    ".nhdr"};

/// Small, so that most of what mutations change is header.
tests::LabelImage phantom() {
  tests::LabelImage image = tests::emptyLabels({6, 5, 4});
  for (std::size_t voxel = 0; voxel < image.voxels.size(); ++voxel)
    image.voxels[voxel] = static_cast<std::int16_t>(37 * voxel % 2000);
  return image;
}

void checkGrid(const std::array<int, 3>& size, const Eigen::Affine3d& indexToLps) {
  require(size[0] > 0 && size[1] > 0 && size[2] > 0, "An image has voxels.");
  require(indexToLps.matrix().allFinite(), "An image has a place.");
  require(indexToLps.linear().determinant() != 0, "An image is not flat.");
}

void checkLabels(const medical_io::LabelMap& map) {
  checkGrid(map.size, map.indexToLps);
  for (const auto& layer : map.layers) {
    require(layer.size() == map.voxelCount(), "A layer has all voxels.");
    layer.visit([&](const auto& voxels) {
      require(voxels.empty() || *std::max_element(voxels.begin(), voxels.end()) <= map.segments.size(),
              "A voxel is of a segment.");
    });
  }
}

void readAnyLabels(Bytes bytes) {
  std::vector<std::string> endings = kImageEndings;
  endings.emplace_back(".dcm");
  const Choice choice = choose(bytes, endings.size());
  Progress progress;
  checkLabels(medical_io::readLabelMap(scratchFile("a" + endings[choice.kind], choice.rest), progress));
}

std::vector<std::string> labelSeeds() {
  std::vector<std::string> out;
  for (const tests::GoodFile& file : tests::goodFiles()) {
    if (file.use != tests::FileUse::labels || !file.besideName.empty())
      continue;
    for (std::size_t kind = kImageEndings.size(); kind-- > 0;)
      if (file.name.ends_with(kImageEndings[kind]))
        out.push_back(chosen(kind, file.bytes));
    if (file.name.ends_with(".dcm"))
      out.push_back(chosen(kImageEndings.size(), file.bytes));
  }
  return out;
}

void readAnySeries(Bytes bytes) {
  const Choice choice = choose(bytes, kImageEndings.size());
  const auto file = scratchFile("a" + kImageEndings[choice.kind], choice.rest);
  Progress progress;
  std::size_t visited = 0;
  const medical_io::SeriesTimes times =
      medical_io::readLabelSeries(file, progress, [&](std::size_t phase, medical_io::LabelMap&& map) {
        require(phase == visited++, "Phases come in order.");
        checkLabels(map);
      });
  require(times.seconds.empty() || times.seconds.size() == visited, "Each phase has its time.");
}

std::vector<std::string> seriesSeeds() {
  std::vector<tests::LabelImage> phases;
  for (int phase = 0; phase < 3; ++phase) {
    phases.push_back(tests::emptyLabels({8, 8, 6}));
    tests::addBall(phases.back(), Vec3::Zero(), 4 + phase, 1);
  }
  const std::string nifti = tests::nifti4d(phases, 0.1, 8);
  return {chosen(0, nifti), chosen(1, tests::gzipped(nifti)), chosen(3, tests::sequenceNrrd(phases, ""))};
}

void checkScan(const std::filesystem::path& place) {
  Progress progress;
  const medical_io::Scan scan = medical_io::readScan(place, {}, progress);
  checkGrid(scan.size, scan.indexToLps);
  require(std::visit([](const auto& all) { return all.size(); }, scan.samples) == scan.voxelCount(),
          "A scan has all samples.");
  scan.range();
  scan.at(scan.indexToLps * Vec3(0.4, 0.4, 0.4));
}

void readAnyScan(Bytes bytes) {
  const Choice choice = choose(bytes, kImageEndings.size());
  checkScan(scratchFile("a" + kImageEndings[choice.kind], choice.rest));
}

std::vector<std::string> scanSeeds() {
  const tests::LabelImage image = phantom();
  return {chosen(0, tests::niftiFile(image)), chosen(1, tests::gzipped(tests::niftiFile(image))),
          chosen(2, tests::nrrdFile(image)), chosen(4, tests::metaImageFile(image))};
}

constexpr std::string_view kNextSlice = "\n==next slice==\n";

/// One to four files of one folder.
void readAnyDicom(Bytes bytes) {
  const std::filesystem::path folder = scratchFolder() / "series";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  const std::string text = textOf(bytes);
  std::size_t begin = 0;
  for (int slice = 0; slice < 4 && begin <= text.size(); ++slice) {
    const std::size_t end = std::min(text.find(kNextSlice, begin), text.size());
    scratchFile("series/" + std::to_string(slice) + ".dcm", bytes.subspan(begin, end - begin));
    begin = end + kNextSlice.size();
  }
  checkScan(folder);
}

std::vector<std::string> dicomSeeds() {
  const tests::LabelImage image = phantom();
  std::vector<std::string> out;
  for (const char* packing :
       {"plain", "rle", "jpeg", "jpeg-lossless", "jpeg-ls", "jpeg-2000", "deflated", "big-endian"}) {
    std::string series;
    for (int k = 0; k < 2; ++k) {
      const std::string plain = tests::dicomBytes(tests::dicomSlice(image, k));
      series += (k > 0 ? std::string(kNextSlice) : "") +
                (std::string(packing) == "plain" ? plain : tests::packedDicom(plain, packing));
    }
    out.push_back(series);
  }
  return out;
}

} // namespace

std::vector<Target> imageTargets() {
  return {{"label_maps", readAnyLabels, labelSeeds},
          {"label_series", readAnySeries, seriesSeeds},
          {"scans", readAnyScan, scanSeeds},
          {"dicom_series", readAnyDicom, dicomSeeds}};
}

} // namespace viscera::fuzz
