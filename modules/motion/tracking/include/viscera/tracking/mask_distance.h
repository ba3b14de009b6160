#pragma once

#include <array>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/tracking/mask.h"
#include "viscera/tracking/surface_distance.h"

namespace viscera::tracking {

/// How far points are from the border of a mask, negative inside: exact Euclidean distances between voxel
/// centres, zero half a voxel from them, smoothed by a Gaussian of 0.7 voxels, trilinear in between and
/// straight on beyond the grid. Thick slices are interpolated first (`betweenSlices`). Immutable; may be
/// asked from several threads.
class MaskDistance final : public SurfaceDistance {
public:
  /// A mask with some voxel inside. Works on its filled part and a margin of `marginMm` around it.
  /// O(voxels of that); bitwise independent of the number of threads.
  explicit MaskDistance(const Mask& mask, double marginMm = 12, Threads threads = {});

  double at(const Vec3& point, Vec3& direction) const override;

  std::size_t bytes() const override { return values_.size() * sizeof(float); }

private:
  std::array<int, 3> size_ = {};
  Eigen::Affine3d lpsToIndex_;
  std::vector<float> values_;
};

} // namespace viscera::tracking
