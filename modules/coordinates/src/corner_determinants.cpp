#include "viscera/coordinates/corner_determinants.h"

#include <algorithm>
#include <cassert>

#include "simd/usable_kernels.h"

namespace viscera::coordinates {
namespace {

/// Points whose rows are multiplied at once: they stay in the cache.
constexpr Eigen::Index kPointsOfABlock = 128;

constexpr Eigen::Index roundedUp(Eigen::Index number, Eigen::Index unit) {
  return (number + unit - 1) / unit * unit;
}

} // namespace

CornerDeterminants::CornerDeterminants(const Binding& binding, const Triangles& triangles)
    : points_(binding.pointCount()), handles_(binding.handleCount()),
      stride_(roundedUp(handles_, simd::kPanel)),
      weights_(allocateZeroed(static_cast<std::size_t>(points_ * stride_))),
      starts_(static_cast<std::size_t>(points_) + 1),
      corners_(static_cast<std::size_t>(triangles.size()) * 2) {
  for (int handle = 0; handle < handles_; ++handle) {
    const Values influence = binding.influence(handle);
    for (Eigen::Index point = 0; point < points_; ++point)
      weights_.get()[point * stride_ + handle] = influence[point];
  }
  for (Eigen::Index i = 0; i < triangles.size(); ++i)
    starts_[static_cast<std::size_t>(triangles.data()[i]) + 1] += 2;
  for (std::size_t point = 1; point < starts_.size(); ++point)
    starts_[point] += starts_[point - 1];
  std::vector<long> next(starts_.begin(), starts_.end() - 1);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    for (int corner = 0; corner < 3; ++corner) {
      long& place = next[static_cast<std::size_t>(triangles(t, corner))];
      corners_[static_cast<std::size_t>(place++)] = triangles(t, (corner + 1) % 3);
      corners_[static_cast<std::size_t>(place++)] = triangles(t, (corner + 2) % 3);
    }
}

void CornerDeterminants::ofHandle(Eigen::Index k, Sums& sums) const {
  assert(k >= 0 && k < handles_);
  // Let R_j(p) = sum over the triangles (p, q, r) at p of a_j(q) a_k(r) - a_j(r) a_k(q), D_ijk is
  // sum_p a_i(p) R_j(p): each determinant, expanded along the column of i, is met at its three corners.
  const simd::DeterminantKernels& kernels = simd::determinantKernels();
  const Eigen::Index width = roundedUp(k, simd::kPanel);
  sums.setZero(width, width);
  const ZeroedMemory panel = allocateZeroed(static_cast<std::size_t>(kPointsOfABlock * simd::kPanel));
  const ZeroedMemory strips = allocateZeroed(static_cast<std::size_t>(kPointsOfABlock * width));
  for (Eigen::Index first = 0; first < points_; first += kPointsOfABlock) {
    const Eigen::Index count = std::min(kPointsOfABlock, points_ - first);
    double* strip = strips.get();
    for (Eigen::Index i = 0; i < width; i += simd::kStrip)
      for (Eigen::Index point = first; point < first + count; ++point, strip += simd::kStrip)
        std::copy_n(row(point) + i, simd::kStrip, strip);
    for (Eigen::Index j = 0; j < width; j += simd::kPanel) {
      if (!kernels.gather(weights_.get(), stride_, k, j, starts_.data() + first, corners_.data(), count,
                          panel.get()))
        break; // Handle k is felt nowhere here.
      for (Eigen::Index i = 0; i < j + simd::kPanel; i += simd::kStrip)
        kernels.multiply(strips.get() + i * count, panel.get(), count, sums.data() + i * width + j, width);
    }
  }
}

} // namespace viscera::coordinates
