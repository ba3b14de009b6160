#include <algorithm>
#include <variant>

#include "beating_labels.h"
#include "dicom_segments.h"
#include "fuzz_target.h"
#include "good_files.h"
#include "label_files.h"
#include "old_image_files.h"
#include "packed_bytes.h"
#include "packed_dicom.h"
#include "structure_sets.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/label_series.h"
#include "viscera/medical_io/scan.h"
#include "viscera/medical_io/surface_file.h"

/// Label maps, their series, and scans.
namespace viscera::fuzz {
namespace {

const std::vector<std::string> kImageEndings = {".nii", ".nii.gz", ".nrrd",     ".seg.nrrd", ".mha",
                                                ".mhd", ".nhdr",   ".mgh",      ".mgz",      ".gipl",
                                                ".hdr", ".mha.gz", ".seq.nrrd", ".nrrd.gz"};

/// The number of an ending.
std::size_t endingOf(std::string_view ending) {
  return static_cast<std::size_t>(std::find(kImageEndings.begin(), kImageEndings.end(), ending) -
                                  kImageEndings.begin());
}

/// The voxels of headers that name other files: "a.img" for Analyze 7.5, "v1.raw" and "v2.raw" for NRRD and
/// MetaImage.
void putVoxelFiles() {
  static const std::string kVoxels(512, '\1');
  const Bytes bytes(reinterpret_cast<const std::uint8_t*>(kVoxels.data()), kVoxels.size());
  for (const char* name : {"a.img", "v1.raw", "v2.raw"})
    scratchFile(name, bytes);
}

/// Kinds that `goodFiles` has none of, as label maps and as scans.
std::vector<std::string> moreSeeds(const tests::LabelImage& image) {
  const std::string nrrd = tests::nrrdFile(image), meta = tests::metaImageFile(image);
  const std::size_t header = nrrd.size() - tests::voxelBytes(image.voxels).size() - 1;
  const std::string longs = "MET_LONG", shorts = "MET_SHORT";
  std::string wide = tests::metaImageHeader(image, "LOCAL");
  wide.replace(wide.find(shorts), shorts.size(), longs);
  return {chosen(endingOf(".mgh"), tests::mghFile(image, 4)),
          chosen(endingOf(".mgz"), tests::gzipped(tests::mghFile(image, 4))),
          chosen(endingOf(".gipl"), tests::giplFile(image, 15)),
          chosen(endingOf(".hdr"), tests::analyzeHeader(image)),
          chosen(endingOf(".mha.gz"), tests::gzipped(meta)),
          chosen(endingOf(".nrrd.gz"), tests::gzipped(nrrd)),
          chosen(endingOf(".mha"), wide + std::string(image.voxels.size() * 4, '\0')),
          chosen(endingOf(".mhd"), tests::metaImageHeader(image, "v%d.raw 1 2 1")),
          chosen(endingOf(".nhdr"), nrrd.substr(0, header) + "data file: LIST\nv1.raw\nv2.raw\n"),
          chosen(endingOf(".nhdr"), nrrd.substr(0, header) + "data file: v%01d.raw 1 2 1 2\n")};
}

std::vector<std::string> mitkSeeds(const tests::LabelImage& image) {
  const std::string groups = R"(org.mitk.multilabel.segmentation.labelgroups:=[{"labels":[{"color":{"value":)"
                             R"([0.8,0.5,0.4]},"name":"Leber","value":1}]}])";
  const std::string xml = "layer_000:=1\norg.mitk.label_000_00000:=<Label><property key=\"name\"><string "
                          "value=\"Liver\"/></property><property key=\"value\"><unsigned "
                          "value=\"1\"/></property></Label>";
  std::vector<std::string> seeds;
  for (const std::string& keys : {groups, xml})
    seeds.push_back(
        chosen(endingOf(".nrrd"), tests::nrrdFile(image, "left-posterior-superior", keys + "\n")));
  return seeds;
}

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
  putVoxelFiles();
  checkLabels(medical_io::readLabelMap(scratchFile("a" + endings[choice.kind], choice.rest), progress));
}

/// Squares on three slices, the middle one with a hole, and a point.
std::string structureSeed() {
  const auto square = [](double half, double z) {
    tests::DrawnContour contour;
    contour.corners.resize(4, 3);
    contour.corners << -half, -half, z, half, -half, z, half, half, z, -half, half, z;
    return contour;
  };
  Points point(1, 3);
  point << 1, 2, 3;
  const tests::DrawnStructure organ{
      .number = 1, .name = "Liver", .contours = {square(4, 0), square(4, 2), square(2, 2), square(4, 4)}};
  const tests::DrawnStructure mark{.number = 2, .name = "Mark", .contours = {{point, "POINT"}}};
  return tests::dicomBytes(tests::structureElements({organ, mark}));
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
  tests::LabelImage image = phantom();
  for (std::int16_t& voxel : image.voxels)
    voxel = static_cast<std::int16_t>(voxel % 3);
  for (const auto& more : {moreSeeds(image), mitkSeeds(image)})
    out.insert(out.end(), more.begin(), more.end());
  tests::LabelImage organs = tests::emptyLabels({6, 5, 4});
  organs.fill({1, 1, 1}, {3, 3, 2}, 2);
  const tests::SegmentWriting labelMap{.type = "LABELMAP", .bits = 8, .names = {{2, "\x1B$B4NB!\x1B(B"}}};
  const tests::DicomElements elements = tests::segmentationElements(organs, labelMap);
  for (const std::string& bytes :
       {tests::dicomBytes(elements), tests::dicomElements(elements),
        tests::packedDicom(tests::dicomBytes(elements), "rle"), tests::rleBits(organs, {}, false)})
    out.push_back(chosen(kImageEndings.size(), bytes));
  out.push_back(chosen(kImageEndings.size(), structureSeed()));
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
  const tests::SegmentWriting overTime{
      .names = {{1, "Ball"}}, .phases = 3, .later = {phases[1], phases[2]}, .stepSeconds = 0.04};
  const std::string segmentation = tests::dicomBytes(tests::segmentationElements(phases.front(), overTime));
  return {chosen(0, nifti), chosen(1, tests::gzipped(nifti)), chosen(2, tests::sequenceNrrd(phases, "")),
          chosen(endingOf(".seq.nrrd"),
                 tests::sequenceNrrd(phases, "axis 0 index unit:=ms\naxis 0 index values:=0 40 80\n")),
          chosen(0, segmentation)};
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
  putVoxelFiles();
  checkScan(scratchFile("a" + kImageEndings[choice.kind], choice.rest));
}

std::vector<std::string> scanSeeds() {
  const tests::LabelImage image = phantom();
  std::vector<std::string> seeds = moreSeeds(image);
  for (const std::string& seed :
       {chosen(0, tests::niftiFile(image)), chosen(1, tests::gzipped(tests::niftiFile(image))),
        chosen(2, tests::nrrdFile(image)), chosen(4, tests::metaImageFile(image))})
    seeds.push_back(seed);
  return seeds;
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
  std::string bare, unknown; // Without preamble; without types.
  for (int k = 0; k < 2; ++k) {
    tests::DicomElements slice = tests::dicomSlice(image, k);
    bare += (k > 0 ? std::string(kNextSlice) : "") + tests::dicomElements(slice);
    for (auto& [tag, typed] : slice)
      if (tag >> 16U <= 0x20)
        typed = "UN" + typed.substr(2);
    unknown += (k > 0 ? std::string(kNextSlice) : "") + tests::dicomBytes(slice);
  }
  out.push_back(bare);
  out.push_back(unknown);
  return out;
}

void readAnyDicomSurface(Bytes bytes) {
  const medical_io::SurfaceFile read = medical_io::readSurface(scratchFile("a.dcm", bytes));
  geometry::requireValid(read.mesh, "what was read");
  require(read.mesh.triangles.rows() > 0, "A surface that was read has triangles.");
}

std::vector<std::string> dicomSurfaceSeeds() {
  const std::string obj = "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  return {tests::dicomBytes({{0x00080016, "UI1.2.840.10008.5.1.4.1.1.104.4"},
                             {0x00080018, "UI1.2.3.4"},
                             {0x004008EA, "SQ" + tests::dicomItem({{0x00080100, "SHcm"}})},
                             {0x00420010, "STLiver"},
                             {0x00420011, "OB" + obj}})};
}

} // namespace

std::vector<Target> imageTargets() {
  return {{"label_maps", readAnyLabels, labelSeeds},
          {"label_series", readAnySeries, seriesSeeds},
          {"scans", readAnyScan, scanSeeds},
          {"dicom_series", readAnyDicom, dicomSeeds},
          {"dicom_surfaces", readAnyDicomSurface, dicomSurfaceSeeds}};
}

} // namespace viscera::fuzz
