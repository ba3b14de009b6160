#pragma once

#include <array>
#include <filesystem>

#include <Eigen/Geometry>

#include "viscera/core/arrays.h"

namespace viscera::medical_io {

/// Writes a NIfTI (.nii, .nii.gz) of vectors, one for each voxel, the first axis fastest: five dimensions,
/// the last of the components, intent code 1007, doubles. Throws as `writeScan`.
void writeVectorImage(const std::filesystem::path& file, const std::array<int, 3>& size,
                      const Eigen::Affine3d& indexToLps, const Points& vectors);

} // namespace viscera::medical_io
