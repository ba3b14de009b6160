#include <new>

#include "dicom/dicom_mark.h"
#include "dicom/dicom_scan.h"
#include "dicom/segmentation_source.h"
#include "file_signature.h"
#include "image_formats/sample_collector.h"
#include "opened_image.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/medical_io/scan.h"

namespace viscera::medical_io {
namespace {

Scan readImageScan(const std::filesystem::path& path, const ScanOptions& options, Progress& progress) {
  OpenedImage image = openImage(path);
  const int phases = image.header.image.layers;
  if (!options.series.empty())
    throw UsageError(misuse("It has no series %1; it is one scan", options.series), path.string());
  if (options.phase < 0 || options.phase >= phases)
    throw UsageError(phrase("It has no phase %1; it has %2", options.phase, phases), path.string(),
                     "the first one is 0");
  SampleCollector collector(image.header.image.scalar);
  try {
    visitPhase(
        image, options.phase, progress, [&](std::size_t count) { collector.reserve(count); },
        [&](const char* bytes, std::size_t count, Scalar scalar, std::endian order) {
          collector.take(bytes, count, scalar, order);
        });
  } catch (const std::bad_alloc&) {
    image.begin.fail("it does not fit into memory", "crop the image to the organs");
  }
  progress.report(1);
  return scanOf(std::move(image), options.phase, collector);
}

ScanSeries describeImage(const std::filesystem::path& path) {
  const OpenedImage opened = openImage(path);
  const RawImage& image = opened.header.image;
  ScanSeries series;
  series.description = stemOf(path);
  series.size = image.size;
  series.spacing = image.indexToLps.linear().colwise().norm();
  series.indexToLps = image.indexToLps;
  series.phases = image.overTime ? image.layers : 1;
  series.files = {path};
  return series;
}

/// A `.seg.nrrd` is always a label map.
bool endsLikeAnImage(const std::filesystem::path& file) {
  const Signature named = signatureOfEnding(file);
  return fileKind(named) == FileKind::labelMap && named != Signature::dicom &&
         !extensionOf(file).starts_with(".seg.");
}

} // namespace

std::vector<ScanSeries> listScans(const std::filesystem::path& fileOrFolder, Progress& progress) {
  if (dicomKind(fileOrFolder) == DicomKind::segmentation)
    return {segmentationSource(fileOrFolder).described};
  if (isDicomPlace(fileOrFolder))
    return listDicomScans(fileOrFolder, progress);
  return {describeImage(fileOrFolder)};
}

Scan readScan(const std::filesystem::path& fileOrFolder, const ScanOptions& options, Progress& progress) {
  if (isDicomPlace(fileOrFolder))
    return readDicomScan(fileOrFolder, options, progress);
  return readImageScan(fileOrFolder, options, progress);
}

bool isScan(const std::filesystem::path& fileOrFolder) {
  std::error_code error;
  if (std::filesystem::is_directory(fileOrFolder, error))
    return hasDicomImages(fileOrFolder);
  return endsLikeAnImage(fileOrFolder) || dicomKind(fileOrFolder) == DicomKind::image;
}

} // namespace viscera::medical_io
