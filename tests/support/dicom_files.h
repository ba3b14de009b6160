#pragma once

#include <string>
#include <vector>

#include "label_files.h"

namespace viscera::tests {

/// Options of a DICOM segmentation for tests.
struct DicomWriting {
  bool fractional = false; ///< Labelled voxels have the largest fraction, 3 of 4 others next to none.
  bool withoutEmptyFrames = true;
  std::vector<std::string> names; ///< Of the labels 1, 2, ...; as many segments.
  std::string characterSet = {};  ///< That these names are written in, "ISO_IR 100"; empty: says none.
  double lastSliceOffMm = 0; ///< The last slice lies so much farther than the others are from each other.
};

/// A DICOM segmentation as DCMTK writes it: one segment a label, one frame a slice. The grid of `image` is
/// right-handed and without shear.
std::string dicomFile(const LabelImage& image, const DicomWriting& writing);

} // namespace viscera::tests
