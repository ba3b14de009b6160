#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "dicom/segmentation_grid.h"
#include "viscera/medical_io/scan.h"

namespace viscera::medical_io {

/// What a DICOM segmentation says of the scan that it was made from.
struct SegmentationSource {
  std::string frameOfReference;            ///< UID of the coordinate system of both.
  SegmentationGrid grid;                   ///< Of the segmentation.
  bool contours = false;                   ///< A structure set: its grid is its own, not its scan's.
  double sliceSpacing = 0;                 ///< As stated in the file, mm; 0: not stated.
  std::set<std::string> series, instances; ///< UIDs of what it refers to; empty: it does not say.
  ScanSeries described;                    ///< The segmentation's own size, spacing and place.
};

/// Reads the header of a segmentation. Throws `DataError`.
SegmentationSource segmentationSource(const std::filesystem::path& file);

/// The frame of reference that a DICOM file states; empty when it states none or cannot be read.
std::string frameOfReferenceIn(const std::filesystem::path& file);

/// Whether the segmentation was made from this series of DICOM images: in the same frame of reference, its
/// voxels are voxels of the series, which it may cover in part, and the series is one that it refers to, if
/// it refers to any. Reads headers of the series' files when only images are referred to.
bool isMadeFrom(const SegmentationSource& segmentation, const ScanSeries& series);

} // namespace viscera::medical_io
