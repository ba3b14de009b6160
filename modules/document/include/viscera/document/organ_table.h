#pragma once

#include <filesystem>
#include <vector>

#include "viscera/document/organ.h"

namespace viscera::document {

/// An organ and its points in the present pose.
struct PosedOrgan {
  std::shared_ptr<const Organ> organ;
  Points points; ///< `n x 3`, mm, as many as its mesh has.
};

/// Writes what is measured of organs as comma-separated values, one row each: `name`, `vertices`,
/// `triangles`, `closed` (yes or no), `rest_ml`, `volume_ml`, `change_ml`, `change_percent` (empty for an
/// open surface), `area_cm2`, `size_x_mm`, `size_y_mm`, `size_z_mm`, `largest_displacement_mm`; all but
/// `rest_ml` in the pose. Six decimals, always with a point. A reader sees the old file or the whole new one.
/// Throws `CannotCreateError`.
void writeOrganTable(const std::filesystem::path& file, const std::vector<PosedOrgan>& organs);

} // namespace viscera::document
