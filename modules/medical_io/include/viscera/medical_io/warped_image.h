#pragma once

#include "viscera/deformation/inverse_map.h"
#include "viscera/deformation/stiff_bodies.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/scan.h"

/// Deforms scans and label maps by a pose of the handles.
namespace viscera::medical_io {

/// The accuracy of deformed images, as a fraction of the smallest voxel spacing.
inline constexpr double kWarpAccuracy = 0.05;

/// The options of an `InverseMap` that reaches `kWarpAccuracy` in an image with that spacing, mm.
deformation::InverseMapOptions warpOptions(const Vec3& spacing);

/// The inverse of a deformation, on a grid and exactly by coordinates, with the organs that do not bend.
struct Warp {
  const deformation::InverseMap& map; ///< Made with `warpOptions`.
  const coordinates::CoordinateSystem& system;
  const deformation::StiffBodies* stiff = nullptr; ///< What does not bend, in the same pose; null: nothing.
};

/// Numbers of the moved and the folded voxels of a deformed image, and its largest error.
struct WarpReport {
  std::size_t moved = 0;  ///< Voxels whose place at rest is another one.
  std::size_t folded = 0; ///< Voxels at which the pose folds the tissue, so that their value is an estimate.
  double largestErrorMm = 0; ///< Of some thousand of the moved ones: `InverseMap::residualMm`.
};

/// The scan deformed by the pose, on its own grid: a voxel at y gets the trilinear value of the scan at rest
/// at x(y), rounded to the sample's type. Voxels from outside of the scan get its padding value, or its
/// lowest value if it has none. O(voxels); a second for ten million on two cores, and binding those between
/// which the map's grid is too coarse. Throws what binding throws, `Cancelled`.
Scan warpedScan(const Scan& scan, const Warp& warp, WarpReport& report, Progress& progress);

/// The label map deformed by the pose: the label of the voxel next to x(y) in each layer. The voxels of
/// segments are counted anew, and segments without voxels are left out with a warning. Throws as
/// `warpedScan`.
LabelMap warpedLabelMap(const LabelMap& map, const Warp& warp, WarpReport& report, Progress& progress);

} // namespace viscera::medical_io
