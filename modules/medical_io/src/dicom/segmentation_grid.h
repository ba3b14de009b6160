#pragma once

#include <array>
#include <vector>

#include "dicom/dicom_header.h"
#include "file_bytes.h"

namespace viscera::medical_io {

/// The voxels of a DICOM segmentation, whose frames may leave slices out.
struct SegmentationGrid {
  std::array<int, 3> size = {};
  Eigen::Affine3d indexToLps = Eigen::Affine3d::Identity(); ///< As `LabelMap::indexToLps`.
  std::vector<int> layers;                                  ///< Of each frame its k.
};

/// Places the frames of a segmentation on one grid, from the lowest slice to the highest along their normal.
/// Throws `DataError` naming `file` when they lie in different directions, at unequal distances, or farther
/// from each other than a file of its length can mean.
SegmentationGrid segmentationGrid(const DicomHeader& header, const FileBytes& file);

} // namespace viscera::medical_io
