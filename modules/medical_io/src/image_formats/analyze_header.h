#pragma once

#include <bit>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/core/phrase.h"

/// Analyze 7.5 (.hdr with .img), the format before NIfTI, as the manual of its authors at the Mayo Clinic and
/// SPM describe it.
namespace viscera::medical_io {

/// The byte order of an Analyze header; nothing for other bytes, among them a NIfTI header.
std::optional<std::endian> orderOfAnalyze(std::string_view bytes);

/// Where an Analyze image lies, as far as its header says: the order of its axes (`orient`), the sizes of its
/// voxels, and the voxel at the origin, which SPM keeps.
struct AnalyzeGrid {
  Eigen::Affine3d indexToLps = Eigen::Affine3d::Identity(); ///< mm.
  std::string axes;                                         ///< Where i, j and k lead: "LAS".
  std::vector<Text> warnings;
};

/// `bytes` begin with a whole Analyze header in that order.
AnalyzeGrid analyzeGrid(std::string_view bytes, std::endian order);

} // namespace viscera::medical_io
