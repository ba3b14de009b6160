#include "viscera/medical_io/cine_study.h"

#include <array>
#include <cmath>

#include "cine_planes.h"
#include "cine_volumes.h"
#include "dicom/cine_slices.h"
#include "dicom/dicom_folder.h"
#include "dicom/dicom_mark.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/scan.h"

namespace viscera::medical_io {
namespace {

[[noreturn]] void failWithoutCine(const std::filesystem::path& place) {
  throw DataError("It has no images over a heart's cycle", place.string(),
                  "name the folder of a cine study, or a file with volumes over time");
}

std::optional<CineStudy> arrangedStudy(std::optional<CineStudy> study) {
  if (study)
    arrangePlanes(*study);
  return study;
}

} // namespace

std::string nameOf(CinePlane plane) {
  // Names in the order of the enumeration.
  constexpr std::array<const char*, 6> kNames = {"short axis", "2-chamber", "3-chamber",
                                                 "4-chamber",  "long axis", "other plane"};
  return kNames[static_cast<std::size_t>(plane)];
}

Vec3 CineGeometry::at(double columnNumber, double rowNumber) const {
  return origin + columnNumber * betweenColumns * row + rowNumber * betweenRows * column;
}

Eigen::Vector2d CineGeometry::pixelOf(const Vec3& point) const {
  const Vec3 from = point - origin;
  return {from.dot(row) / betweenColumns, from.dot(column) / betweenRows};
}

std::size_t CineSlice::phaseAt(double fraction) const {
  std::size_t nearest = 0;
  double least = 1;
  for (std::size_t phase = 0; phase < fractions.size(); ++phase) {
    const double off = std::abs(std::remainder(fraction - fractions[phase], 1));
    if (off < least) {
      least = off;
      nearest = phase;
    }
  }
  return nearest;
}

namespace {

/// Whether a place has series that are the phases of one scan; those of other folders are not asked for.
bool hasGatedScan(const std::filesystem::path& folder, Progress& progress) {
  try {
    const std::vector<ScanSeries> series = listScans(folder, progress);
    return !series.empty() && series.front().phases > 1 && series.front().id.ends_with("@gated");
  } catch (const DataError&) {
    return false;
  }
}

} // namespace

std::optional<CineStudy> findCineStudy(const std::filesystem::path& place, Progress& progress,
                                       const CineOptions& options) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(place, ignored) && std::filesystem::exists(place, ignored) &&
      dicomKind(place) == DicomKind::none)
    return arrangedStudy(cineOfVolumes(place, progress, options));
  const bool isFolder = std::filesystem::is_directory(place, ignored);
  auto study = dicomCine(isFolder ? place : place.parent_path(), dicomImages(place), progress, options);
  if (!study && isFolder && hasGatedScan(place, progress))
    study = cineOfVolumes(place, progress, options);
  return arrangedStudy(std::move(study));
}

CineStudy readCineStudy(const std::filesystem::path& place, Progress& progress, const CineOptions& options) {
  if (auto study = findCineStudy(place, progress, options))
    return std::move(*study);
  failWithoutCine(place);
}

CineStudy readCineStudy(const std::vector<std::filesystem::path>& files, Progress& progress,
                        const CineOptions& options) {
  if (files.empty())
    throw UsageError(misuse("There are no files"));
  if (auto study = arrangedStudy(dicomCine(files.front().parent_path(), files, progress, options)))
    return std::move(*study);
  failWithoutCine(files.front());
}

} // namespace viscera::medical_io
