#pragma once

#include <array>
#include <functional>
#include <vector>

#include <Eigen/Geometry>

#include "viscera/core/arrays.h"
#include "viscera/core/parallel.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::phantom {

/// The voxels of an image: their number, and their places.
struct ImageGrid {
  std::array<int, 3> size = {1, 1, 1}; ///< Along i, j and k.
  /// Maps (i, j, k) to mm LPS; whole numbers are centres of voxels. Not singular.
  Eigen::Affine3d indexToLps = Eigen::Affine3d::Identity();

  std::size_t voxels() const { return std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]); }
  double voxelMm3() const { return std::abs(indexToLps.linear().determinant()); }
  /// The centres of one layer, `size[0] * size[1] x 3` mm, i fastest.
  Points centersOf(int k) const;
};

/// A closed surface and the number of what is in it.
struct PaintedSurface {
  const Points* points = nullptr; ///< `n x 3` mm LPS; not null.
  const Triangles* triangles = nullptr;
  int paint = 0; ///< 1 to 255; where surfaces overlap, the highest counts.
};

/// A part of a line along i that is in one surface.
struct RowPart {
  int k = 0, j = 0;          ///< The row of voxels.
  double begin = 0, end = 0; ///< Along i, in voxels: whole numbers are centres.
  int paint = 0;
};

/// How many lines along i go through one row of voxels, side by side. One goes through the centres.
struct LinesOfARow {
  int acrossJ = 1;
  int acrossK = 1;
};

/// Cuts lines along the rows of a grid with closed surfaces: exact but for rounding, whatever the triangles
/// are, since neighbours share the very points at which a line meets their common edge. Calls `visit` with
/// the parts of all rows of one layer k, in order, from one thread; layers in any order, from several.
/// O(triangles + parts).
void coverRows(const ImageGrid& grid, const std::vector<PaintedSurface>& surfaces, const LinesOfARow& lines,
               Threads threads, const std::function<void(const std::vector<RowPart>& layer, int k)>& visit);

/// The paint at the centre of every voxel, i fastest; 0 outside of all surfaces. As `coverRows`.
std::vector<std::uint8_t> paintAtCenters(const ImageGrid& grid, const std::vector<PaintedSurface>& surfaces,
                                         Threads threads = {});

} // namespace viscera::phantom
