#include "cine_volumes.h"

#include <cmath>
#include <utility>

#include "viscera/medical_io/scan_over_time.h"

namespace viscera::medical_io {
namespace {

/// Layer k of a volume, NaN where nothing was measured.
CineImage layerOf(const Scan& scan, int k) {
  CineImage image(scan.size[1], scan.size[0]);
  for (int j = 0; j < scan.size[1]; ++j)
    for (int i = 0; i < scan.size[0]; ++i)
      image(j, i) = static_cast<float>(scan.value(i, j, k));
  return image;
}

CineGeometry geometryOf(const Scan& scan) {
  CineGeometry geometry;
  geometry.origin = scan.indexToLps.translation();
  geometry.row = scan.indexToLps.linear().col(0).normalized();
  geometry.column = scan.indexToLps.linear().col(1).normalized();
  geometry.betweenColumns = scan.spacing()[0];
  geometry.betweenRows = scan.spacing()[1];
  geometry.thickness = std::abs(geometry.normal().dot(scan.indexToLps.linear().col(2)));
  geometry.columns = scan.size[0];
  geometry.rows = scan.size[1];
  return geometry;
}

} // namespace

std::optional<CineStudy> cineOfVolumes(const std::filesystem::path& place, Progress& progress,
                                       const CineOptions& options) {
  const auto beat = readScanOverTime(place, {}, progress, {options.keptBytes});
  if (!beat || beat->fractions.size() < 2)
    return std::nullopt;
  const std::shared_ptr<const Scan> first = beat->volume(0);
  CineStudy study;
  study.patientName = first->patientName;
  study.date = first->studyDate;
  study.modality = beat->modality;
  study.findings = beat->findings;
  CineSlice slice;
  slice.series = beat->series;
  slice.description = beat->description;
  slice.date = first->studyDate;
  slice.geometry = geometryOf(*first);
  slice.fractions = beat->fractions;
  slice.missing = beat->missing;
  slice.interval = beat->periodSeconds;
  for (int k = 0; k < first->size[2]; ++k) {
    slice.image = [volume = beat->volume, k](std::size_t phase) {
      return std::make_shared<const CineImage>(layerOf(*volume(phase), k));
    };
    study.slices.push_back(slice);
    slice.geometry.origin += first->indexToLps.linear().col(2);
  }
  return study;
}

} // namespace viscera::medical_io
