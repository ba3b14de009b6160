#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::tracking {

/// A binary image: the voxels of a grid that belong to the inside of a surface. The grid has no shear; it may
/// be oblique or left-handed.
struct Mask {
  std::array<int, 3> size = {}; ///< Voxels along i, j and k.
  /// Maps (i, j, k) to mm LPS; the centre of the first voxel is (0, 0, 0).
  Eigen::Affine3d indexToLps = Eigen::Affine3d::Identity();
  std::vector<std::uint8_t> inside; ///< i fastest; 0 or 1.

  std::size_t indexOf(int i, int j, int k) const {
    return (std::size_t(k) * std::size_t(size[1]) + std::size_t(j)) * std::size_t(size[0]) + std::size_t(i);
  }
  /// Distance of neighbouring voxels along i, j and k, mm.
  Vec3 spacing() const { return indexToLps.linear().colwise().norm(); }
  std::int64_t count() const;
  /// Volume of the voxels that are inside, ml.
  double volumeMl() const;
};

/// The voxels from `low` to `high`, both included.
struct VoxelRange {
  std::array<int, 3> low = {}, high = {};
};

/// The smallest range that holds all voxels inside; high below low for none. O(voxels).
VoxelRange rangeOf(const Mask& mask);

/// The voxels of `range`, which may reach beyond the mask: nothing is inside there. O(voxels of the range).
Mask cropped(const Mask& mask, const VoxelRange& range);

/// The axis along which voxels are more than twice as long as along the others; -1 for none.
int thickAxis(const Mask& mask);

/// A mask with thick slices as one whose voxels are as long across as within the slices: signed distances
/// within the slices, linear between them (shape-based interpolation: Raya and Udupa 1990, doi
/// 10.1109/42.52980), with flat ends half a slice beyond the outer ones. Other masks are returned unchanged.
/// O(voxels of the result).
Mask betweenSlices(const Mask& mask);

/// The voxels of `grid` whose centres lie within a closed surface (mm LPS); a ray along i crosses it an odd
/// number of times. Only size and place of `grid` are used, not its contents. O(triangles x the rows that
/// they touch + voxels).
///
///     Mask grid;
///     grid.size = {20, 20, 20};
///     grid.indexToLps.translation() = Vec3(-9.5, -9.5, -9.5);
///     const Mask filled = voxelised(surface, grid);
///     const double ml = filled.volumeMl();
Mask voxelised(const geometry::TriangleMesh& surface, const Mask& grid);

/// How well two masks on one grid agree: 2 |A and B| / (|A| + |B|), 1 for two empty ones. O(voxels).
double diceOf(const Mask& a, const Mask& b);

} // namespace viscera::tracking
