#include "viscera/medical_io/label_map.h"

#include <algorithm>
#include <new>
#include <optional>

#include "dicom/dicom_mark.h"
#include "file_bytes.h"
#include "file_signature.h"
#include "freesurfer_names.h"
#include "image_formats/data_file.h"
#include "image_formats/label_encoding.h"
#include "image_formats/raw_image.h"
#include "label_segments.h"
#include "label_tables.h"
#include "opened_image.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

constexpr std::size_t kMostTimesTold = 12;
constexpr double kWrittenOut = 1e-5; ///< A distance below it is told with its power of ten.

struct LabelMapFormat {
  Signature signature;
  ImageHeader (*readHeader)(FileBytes&); ///< Null for DICOM, whose segmentations have no plain voxels.
};

constexpr std::array<LabelMapFormat, 6> kLabelMapFormats = {{{Signature::nifti, niftiHeader},
                                                             {Signature::nrrd, nrrdHeader},
                                                             {Signature::metaImage, metaImageHeader},
                                                             {Signature::mgh, mghHeader},
                                                             {Signature::gipl, giplHeader},
                                                             {Signature::dicom, nullptr}}};

const LabelMapFormat& labelFormatOf(const FileBytes& file) {
  const Signature signature = signatureFor(file, FileKind::labelMap);
  return *std::find_if(kLabelMapFormats.begin(), kLabelMapFormats.end(),
                       [&](const LabelMapFormat& format) { return format.signature == signature; });
}

void warnOfEmptySegments(LabelMap& map, const std::vector<StatedSegment>& stated) {
  std::size_t empty = 0;
  std::string first;
  for (const StatedSegment& one : stated) {
    const bool found = std::any_of(map.segments.begin(), map.segments.end(), [&](const Segment& s) {
      return s.label == one.label && s.layer == one.layer;
    });
    if (!found && empty++ == 0)
      first = one.name;
  }
  if (empty > 0)
    map.warnings.push_back(
        phrase("%n {segment has|segments have} no voxels (%2)", empty, first + (empty > 1 ? ", ..." : "")));
}

} // namespace

namespace {

/// `raw` without its values.
LabelMap labelMapOf(RawImage&& raw, EncodedLabels&& encoded, Progress& progress) {
  if (encoded.farthest > 0)
    raw.warnings.push_back(phrase(
        "its values are not exactly whole numbers; they were rounded to labels, by at most %1",
        encoded.farthest < kWrittenOut ? inDigits(encoded.farthest, 2) : inFixed(encoded.farthest, 5)));
  LabelMap map;
  map.size = raw.size;
  map.indexToLps = raw.indexToLps;
  map.layers = std::move(encoded.layers);
  map.space = std::move(raw.space);
  map.warnings = std::move(raw.warnings);
  for (const auto& [layer, label] : encoded.labels) {
    Segment& segment = map.segments.emplace_back();
    segment.label = label;
    segment.layer = layer;
  }
  measureSegments(map, progress);
  nameSegments(map, raw.stated);
  return map;
}

/// Says which of several phases can be chosen, and how.
[[noreturn]] void failAsSeries(const FileBytes& file, const RawImage& raw) {
  const std::vector<double> times = statedPhaseTimes(raw);
  std::vector<Text> list;
  for (const double time : times)
    list.push_back(inDigits(time, 4));
  file.fail(
      times.empty() || times.size() > kMostTimesTold
          ? phrase("It has %1 label maps over time, of which one is needed here", raw.layers)
          : phrase("It has %1 label maps over time (at %2 ms), of which one is needed here", raw.layers,
                   listOf(list)),
      phrase("follow the motion over all of them with viscera track %1, or choose one with --phase, from "
             "0 to %2",
             file.file.filename().string(), raw.layers - 1));
}

void requirePhase(const FileBytes& file, const RawImage& raw, std::optional<int> phase) {
  const int phases = raw.overTime ? raw.layers : 1;
  if (!phase && phases > 1)
    failAsSeries(file, raw);
  if (phase && (*phase < 0 || *phase >= phases))
    throw UsageError(phrase("It has no phase %1; it has %2", *phase, phases), file.name(),
                     "the first one is 0");
}

/// Reads one phase of a series, block by block.
LabelMap readPhase(ImageHeader&& header, const FileBytes& begin, int phase, Progress& progress) {
  OpenedImage opened{begin, std::move(header)};
  RawImage raw = opened.header.image;
  raw.layers = 1;
  LabelEncoder encoder(raw);
  visitPhase(
      opened, phase, progress, [&](std::size_t) { encoder.reserve(); },
      [&](const char* bytes, std::size_t count, Scalar scalar, std::endian order) {
        encoder.take(bytes, count, scalar, order);
      });
  requireUsableGrid(raw, begin);
  EncodedLabels encoded = encoder.finish(raw, begin);
  std::vector<double> times = statedPhaseTimes(opened.header.image);
  for (int i = 0; times.size() < static_cast<std::size_t>(opened.header.image.layers); ++i)
    times.push_back(i);
  LabelMap map = labelMapOf(std::move(raw), std::move(encoded), progress);
  map.phase = phase;
  map.phaseTimesMs = std::move(times);
  return map;
}

/// Reads the voxels behind a header, block by block.
LabelMap readVoxels(ImageHeader&& header, const FileBytes& begin, std::optional<int> phase,
                    Progress& progress) {
  requirePhase(begin, header.image, phase);
  if (header.image.overTime)
    return readPhase(std::move(header), begin, phase.value_or(0), progress);
  RawImage& raw = header.image;
  LabelEncoder encoder(raw);
  visitValues(
      begin, header.stored, raw, {0, raw.valueCount()}, progress, [&](std::uint64_t) { encoder.reserve(); },
      [&](const char* bytes, std::size_t count) { encoder.take(bytes, count, raw.scalar, raw.order); });
  requireUsableGrid(raw, begin);
  EncodedLabels encoded = encoder.finish(raw, begin);
  return labelMapOf(std::move(raw), std::move(encoded), progress);
}

/// The map with the names of all labels. Numbers alone say names in volumes of FreeSurfer only.
LabelMap completed(LabelMap&& map, const std::filesystem::path& file, Signature kind) {
  if (map.segments.empty())
    throw DataError("It has no labelled voxel: all are 0", file.string(),
                    "check that the segmentation was saved");
  nameByTable(map, file);
  if (kind == Signature::mgh)
    nameAsFreeSurfer(map);
  completeSegments(map);
  return std::move(map);
}

/// The names of labels without voxels. Tables of all classes there are, as TotalSegmentator writes them into
/// NIfTI, are no loss.
std::vector<StatedSegment> namesToMiss(const LabelMapFormat& format, const RawImage& raw) {
  return format.signature == Signature::nifti ? std::vector<StatedSegment>() : raw.stated;
}

} // namespace

LabelMap labelMapOf(RawImage&& raw, const FileBytes& file, Progress& progress) {
  requireUsableGrid(raw, file);
  EncodedLabels encoded = encodeLabels(raw, file, progress);
  raw.storage = {};
  return labelMapOf(std::move(raw), std::move(encoded), progress);
}

LabelMap labelMapOf(OpenedImage&& image, NumberedLayer&& layer, Progress& progress) {
  const LabelMapFormat& format = labelFormatOf(image.begin);
  const std::vector<StatedSegment> stated = namesToMiss(format, image.header.image);
  std::vector<NumberedLayer> layers;
  layers.push_back(std::move(layer));
  EncodedLabels encoded = encodedLabels(std::move(layers), image.header.image, image.begin);
  LabelMap map = labelMapOf(std::move(image.header.image), std::move(encoded), progress);
  warnOfEmptySegments(map, stated);
  map = completed(std::move(map), image.begin.file, format.signature);
  progress.report(1);
  return map;
}

void nameByTable(LabelMap& map, const std::filesystem::path& file) {
  if (std::any_of(map.segments.begin(), map.segments.end(), [](const Segment& s) { return s.named; }))
    return;
  const LabelTable table = findLabelTable(file);
  if (table.segments.empty())
    return;
  nameSegments(map, table.segments);
  map.warnings.push_back(phrase("the names of its labels are those of %1", table.file.filename().string()));
}

Bounds LabelMap::bounds() const {
  return boundsOfVoxels(size, indexToLps);
}

namespace {

LabelMap readByFormat(FileBytes& begin, const LabelMapFormat& format, std::optional<int> phase,
                      Progress& progress) {
  try {
    if (format.readHeader == nullptr) {
      requirePhase(begin, RawImage(), phase);
      begin = readRestOfFile(begin);
      RawImage raw = readDicomSegmentation(begin);
      const std::vector<StatedSegment> stated = raw.stated;
      LabelMap map = labelMapOf(std::move(raw), begin, progress);
      warnOfEmptySegments(map, stated);
      return map;
    }
    ImageHeader header = format.readHeader(begin);
    const std::vector<StatedSegment> stated = namesToMiss(format, header.image);
    LabelMap map = readVoxels(std::move(header), begin, phase, progress);
    warnOfEmptySegments(map, stated);
    return map;
  } catch (const std::bad_alloc&) {
    begin.fail("it does not fit into memory", "crop the image to the organs");
  }
}

} // namespace

LabelMap readLabelFile(const std::filesystem::path& file, Progress& progress) {
  FileBytes begin = readBeginOfFile(file, kMostHeaderBytes);
  return readByFormat(begin, labelFormatOf(begin), std::nullopt, progress);
}

LabelMap readLabelMap(const std::filesystem::path& file, Progress& progress, std::optional<int> phase) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored))
    return readLabelFolder(file, progress);
  FileBytes begin = readBeginOfFile(file, kMostHeaderBytes);
  const LabelMapFormat& format = labelFormatOf(begin);
  LabelMap map = completed(readByFormat(begin, format, phase, progress), file, format.signature);
  progress.report(1);
  return map;
}

bool isLabelMap(const std::filesystem::path& fileOrFolder) {
  const auto isOne = [](const std::filesystem::path& file) {
    switch (dicomKind(file)) {
    case DicomKind::segmentation:
      return true;
    case DicomKind::image:
    case DicomKind::surface:
    case DicomKind::other:
      return false;
    case DicomKind::none:
      break;
    }
    return fileKind(signatureOfEnding(file)) == FileKind::labelMap;
  };
  std::error_code error;
  if (!std::filesystem::is_directory(fileOrFolder, error))
    return isOne(fileOrFolder);
  for (std::filesystem::directory_iterator entry(fileOrFolder, error), end; !error && entry != end;
       entry.increment(error))
    if (isOne(entry->path()))
      return true;
  return false;
}

} // namespace viscera::medical_io
