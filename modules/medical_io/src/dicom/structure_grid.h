#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "dicom/structure_set.h"
#include "file_bytes.h"

/// Fills the contours of a structure set on a grid.
namespace viscera::medical_io {

/// A region's contours in one plane, in the axes of the grid.
struct DrawnPlane {
  double offset = 0;                                              ///< Along the normal, mm.
  std::vector<Eigen::Matrix<double, 2, Eigen::Dynamic>> contours; ///< Corners, mm along the axes.
  double area = 0;                                                ///< mm^2, without holes.
};

/// The contours of all regions on planes of one direction, and the grid that they are filled on.
struct StructureGrid {
  std::array<int, 3> size = {};
  Eigen::Affine3d indexToLps = Eigen::Affine3d::Identity();
  std::vector<std::vector<DrawnPlane>> regions; ///< Of each region its planes, by ascending offset.
  std::size_t aslant = 0;                       ///< Contours in planes of another direction, left out.
  bool single = false;                          ///< All contours lie in one plane: its thickness is a guess.
};

/// Finds the direction that most contours lie in; slices as far apart as the two nearest planes; pixels so
/// fine that the smallest region is filled within 1 % of its area, as far as memory for `mostVoxels` allows.
/// Throws `DataError` naming `file` where nothing is left to be filled, or where it is farther than an image
/// can be large.
StructureGrid structureGrid(const StructureSet& set, const FileBytes& file,
                            std::size_t mostVoxels = std::size_t{1} << 26U);

/// A region's voxels: 1 inside, i fastest.
struct FilledRegion {
  std::vector<std::uint8_t> voxels; ///< Of the slices from `first` on.
  int first = 0;
  int slices = 0;
  std::size_t interpolated = 0; ///< Slices that lack a contour, filled by the shapes beside them.
  double gap = 0;               ///< The longest distance of contours that was left empty, mm; 0: none.
};

/// Fills by the even-odd rule, so that a contour within another is a hole, and one that runs to its hole and
/// back (a keyhole) has it, too. Slices between two contours get the shape between them (signed distances in
/// the plane, blended) unless these are more than four times as far apart as the region's usually are. A
/// contour stands for half that usual distance on both sides. O(voxels of its box) and O(corners rows).
FilledRegion fillRegion(const StructureGrid& grid, std::size_t region);

} // namespace viscera::medical_io
