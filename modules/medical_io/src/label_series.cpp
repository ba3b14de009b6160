#include "viscera/medical_io/label_series.h"

#include <algorithm>
#include <cmath>
#include <new>

#include "dicom/dicom_mark.h"
#include "file_bytes.h"
#include "file_signature.h"
#include "image_formats/data_file.h"
#include "label_segments.h"
#include "opened_image.h"
#include "viscera/core/error.h"

namespace viscera::medical_io {
namespace {

/// Cycles a second that a heart makes.
constexpr double kSlowestHz = 0.2, kFastestHz = 4;

/// The header of a file whose volumes are phases, or that has only one.
ImageHeader seriesHeaderOf(FileBytes& file) {
  const Signature found = signatureUnpacked(file);
  const bool isImage = found == Signature::nifti || found == Signature::nrrd ||
                       found == Signature::metaImage || found == Signature::mgh || found == Signature::gipl;
  if (!isImage)
    file.fail("It is not a file with several phases",
              "name a 4D NIfTI, a .seq.nrrd of 3D Slicer, or one file for each phase");
  OpenedImage opened = openImage(file.file);
  file = std::move(opened.begin);
  return std::move(opened.header);
}

/// The same with all values.
RawImage rawSeriesOf(FileBytes& file, Progress& progress) {
  ImageHeader header = seriesHeaderOf(file);
  RawImage& raw = header.image;
  if (raw.layers > 1 && !raw.overTime)
    file.fail("It has several layers of one label map, not several phases",
              "name a 4D NIfTI, a .seq.nrrd of 3D Slicer, or one file for each phase");
  std::string values;
  visitValues(
      file, header.stored, raw, {0, raw.valueCount()}, progress,
      [&](std::uint64_t) { values.reserve(static_cast<std::size_t>(raw.byteCount())); },
      [&](const char* bytes, std::size_t count) { values.append(bytes, count * sizeOf(raw.scalar)); });
  raw.storage = std::move(values);
  raw.offset = 0;
  return std::move(header.image);
}

/// The values of one volume behind each other, out of those of all.
std::string volumeOf(const RawImage& raw, std::size_t volume) {
  const std::size_t width = sizeOf(raw.scalar), count = static_cast<std::size_t>(raw.layers);
  const std::size_t voxels = static_cast<std::size_t>(raw.valueCount()) / count;
  if (!raw.layersFirst)
    return std::string(raw.values().substr(volume * voxels * width, voxels * width));
  std::string bytes;
  bytes.reserve(voxels * width);
  for (std::size_t v = 0; v < voxels; ++v)
    bytes.append(raw.values().substr((v * count + volume) * width, width));
  return bytes;
}

bool plausible(double periodSeconds) {
  return periodSeconds > 1 / kFastestHz && periodSeconds < 1 / kSlowestHz;
}

/// Interprets the times stated in a file; empty if the unit is missing and no unit gives a plausible
/// heartbeat.
SeriesTimes timesOf(const RawTimes& stated, std::size_t count) {
  SeriesTimes times;
  std::vector<double> values = stated.values;
  if (values.empty() && stated.step > 0)
    for (std::size_t i = 0; i < count; ++i)
      values.push_back(stated.step * static_cast<double>(i));
  const bool usable = values.size() == count && count > 1 &&
                      std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  if (!usable)
    return times;
  const double period =
      (values.back() - values.front()) / static_cast<double>(count - 1) * static_cast<double>(count);
  double unit = secondsAUnit(stated.unit);
  if (unit == 0 && stated.unit.empty() && !stated.values.empty() && plausible(1e-3 * period)) {
    unit = 1e-3;
    times.doubt = "It does not say the unit of its times; they are taken as milliseconds";
  }
  for (const double value : values)
    times.seconds.push_back((value - values.front()) * (unit > 0 ? unit : 1));
  if (unit > 0 && plausible(unit * period))
    times.periodSeconds = unit * period;
  return times;
}

/// The phases of a DICOM segmentation; those that do not follow each other in time have no times.
SeriesTimes readDicomSeries(FileBytes& file, Progress& progress,
                            const std::function<void(std::size_t, LabelMap&&)>& visit) {
  file = readRestOfFile(file);
  const std::vector<DicomPhase> phases =
      readDicomSegmentations(file, [&](std::size_t phase, std::size_t count, RawImage&& image) {
        progress.report(static_cast<double>(phase) / static_cast<double>(count),
                        named("volume " + std::to_string(phase + 1)));
        progress.throwIfCancelled();
        if (phase > 0)
          image.warnings.clear();
        Progress quiet;
        LabelMap map = labelMapOf(std::move(image), file, quiet);
        nameByTable(map, file.file);
        completeSegments(map);
        visit(phase, std::move(map));
      });
  progress.report(1);
  SeriesTimes times = medical_io::timesOf(phases);
  const auto isBack = [](double before, double after) { return !(after > before); };
  if (std::adjacent_find(times.seconds.begin(), times.seconds.end(), isBack) != times.seconds.end() ||
      !std::isfinite(times.periodSeconds.value_or(0)))
    return {};
  return times;
}

} // namespace

std::size_t volumesIn(const std::filesystem::path& file) {
  if (!isLabelMap(file) || isDicomPlace(file))
    return 1;
  const OpenedImage image = openImage(file);
  return image.header.image.overTime ? static_cast<std::size_t>(image.header.image.layers) : 1;
}

SeriesTimes readLabelSeries(const std::filesystem::path& file, Progress& progress,
                            const std::function<void(std::size_t, LabelMap&&)>& visit) {
  FileBytes bytes = readBeginOfFile(file, kMostHeaderBytes);
  try {
    if (dicomKind(file) == DicomKind::segmentation)
      return readDicomSeries(bytes, progress, visit);
    Progress reading;
    const RawImage raw = rawSeriesOf(bytes, reading);
    const auto count = static_cast<std::size_t>(raw.layers);
    for (std::size_t volume = 0; volume < count; ++volume) {
      progress.report(static_cast<double>(volume) / static_cast<double>(count),
                      named("volume " + std::to_string(volume + 1)));
      progress.throwIfCancelled();
      RawImage one;
      one.size = raw.size;
      one.indexToLps = raw.indexToLps;
      one.scalar = raw.scalar;
      one.order = raw.order;
      one.slope = raw.slope;
      one.intercept = raw.intercept;
      one.stated = raw.stated;
      one.space = raw.space;
      if (volume == 0)
        one.warnings = raw.warnings;
      one.storage = volumeOf(raw, volume);
      Progress quiet;
      LabelMap map = labelMapOf(std::move(one), bytes, quiet);
      nameByTable(map, file);
      completeSegments(map);
      visit(volume, std::move(map));
    }
    progress.report(1);
    return timesOf(raw.times.value_or(RawTimes{}), count);
  } catch (const std::bad_alloc&) {
    bytes.fail("it does not fit into memory", "crop the image to the organs");
  }
}

SeriesTimes timesOf(const std::vector<DicomPhase>& phases) {
  SeriesTimes times;
  const auto all = [&](auto member) {
    return std::all_of(phases.begin(), phases.end(),
                       [&](const DicomPhase& phase) { return (phase.*member).has_value(); });
  };
  if (phases.size() < 2)
    return times;
  const auto count = static_cast<double>(phases.size());
  if (all(&DicomPhase::nominalIntervalMs))
    times.periodSeconds = *phases.front().nominalIntervalMs / 1000;
  if (all(&DicomPhase::triggerMs)) {
    for (const DicomPhase& phase : phases)
      times.seconds.push_back((*phase.triggerMs - *phases.front().triggerMs) / 1000);
    if (!times.periodSeconds)
      times.periodSeconds = times.seconds.back() / (count - 1) * count;
  } else if (all(&DicomPhase::percent) && times.periodSeconds) {
    for (const DicomPhase& phase : phases)
      times.seconds.push_back((*phase.percent - *phases.front().percent) / 100 * *times.periodSeconds);
  }
  return times;
}

} // namespace viscera::medical_io
