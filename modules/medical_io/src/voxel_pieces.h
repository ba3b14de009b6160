#pragma once

#include <cstdint>
#include <vector>

#include "viscera/medical_io/label_map.h"

namespace viscera::medical_io {

/// The voxels of a segment, in a box one voxel larger than they are on every side.
struct VoxelBox {
  std::array<int, 3> low = {};      ///< The box's first voxel in the map; may be -1.
  std::array<int, 3> size = {};     ///< Its voxels.
  std::vector<std::uint8_t> inside; ///< 1 for the segment's, i fastest.
  std::int64_t count = 0;           ///< Of those.
};

/// Cuts the segment out. O(voxels of the box).
VoxelBox voxelsOf(const LabelMap& map, std::size_t segment);

/// The pieces of voxels that are connected by faces.
struct VoxelPieces {
  int count = 0;
  std::int64_t largest = 0; ///< Voxels of the largest piece.
};

/// Counts the pieces; with `keepLargest` those but the largest (of equal ones the first) become 0 in `box`.
/// O(voxels of the box).
VoxelPieces voxelPieces(VoxelBox& box, bool keepLargest);

} // namespace viscera::medical_io
