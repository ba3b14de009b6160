#include "viscera/tracking/mask_distance.h"

#include <algorithm>
#include <cmath>

#include "viscera/geometry/squared_distances.h"

namespace viscera::tracking {
namespace {

constexpr double kSigma = 0.7; ///< Voxels.
constexpr int kReach = 3;      ///< Voxels; four sigmas.
constexpr Eigen::Index kLines = 64;

/// Gaussian weights, which sum to one.
std::array<float, kReach + 1> kernel() {
  std::array<float, kReach + 1> weights{};
  double sum = 0;
  for (int i = 0; i <= kReach; ++i)
    sum += (i == 0 ? 1 : 2) * std::exp(-0.5 * i * i / (kSigma * kSigma));
  for (int i = 0; i <= kReach; ++i)
    weights[static_cast<std::size_t>(i)] =
        static_cast<float>(std::exp(-0.5 * i * i / (kSigma * kSigma)) / sum);
  return weights;
}

/// Along one axis after the other; values beyond the grid are mirrored.
void smoothen(std::vector<float>& values, const std::array<int, 3>& size, Threads threads) {
  const std::array<float, kReach + 1> weights = kernel();
  const std::array<std::size_t, 3> n = {std::size_t(size[0]), std::size_t(size[1]), std::size_t(size[2])};
  const std::array<std::size_t, 3> stride = {1, n[0], n[0] * n[1]};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t b = (axis + 1) % 3, c = (axis + 2) % 3;
    const auto last = static_cast<std::ptrdiff_t>(n[axis]) - 1;
    parallelRanges(static_cast<Eigen::Index>(n[b] * n[c]), kLines, threads,
                   [&](Eigen::Index begin, Eigen::Index end) {
                     std::vector<float> line(n[axis]);
                     const auto mirrored = [&](std::ptrdiff_t i) {
                       i = i < 0 ? -i - 1 : i > last ? 2 * last + 1 - i : i;
                       return line[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, last))];
                     };
                     for (auto l = static_cast<std::size_t>(begin); l < static_cast<std::size_t>(end); ++l) {
                       float* data = values.data() + l % n[b] * stride[b] + l / n[b] * stride[c];
                       for (std::size_t i = 0; i < n[axis]; ++i)
                         line[i] = data[i * stride[axis]];
                       for (std::ptrdiff_t i = 0; i <= last; ++i) {
                         float sum = weights[0] * line[static_cast<std::size_t>(i)];
                         for (int k = 1; k <= kReach; ++k)
                           sum += weights[static_cast<std::size_t>(k)] * (mirrored(i - k) + mirrored(i + k));
                         data[static_cast<std::size_t>(i) * stride[axis]] = sum;
                       }
                     }
                   });
  }
}

/// The filled part of a mask with a margin around it.
Mask withMargin(const Mask& mask, double marginMm) {
  VoxelRange range = rangeOf(mask);
  const Vec3 spacing = mask.spacing();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int margin = std::max(2, static_cast<int>(std::ceil(marginMm / spacing[static_cast<int>(axis)])));
    range.low[axis] -= margin;
    range.high[axis] += margin;
  }
  return cropped(mask, range);
}

} // namespace

MaskDistance::MaskDistance(const Mask& mask, double marginMm, Threads threads) {
  const Mask fine = withMargin(betweenSlices(mask), marginMm);
  const Vec3 spacing = fine.spacing();
  const std::array<bool, 3> everywhere = {true, true, true};
  values_ = geometry::squaredDistances(fine.inside, 1, fine.size, spacing, everywhere, threads);
  const std::vector<float> out =
      geometry::squaredDistances(fine.inside, 0, fine.size, spacing, everywhere, threads);
  // Between a voxel and its neighbour on the other side the surface is half way, so that half a voxel comes
  // off the distance between centres on either side.
  const auto half = static_cast<float>(spacing.minCoeff() / 2);
  for (std::size_t v = 0; v < values_.size(); ++v)
    values_[v] = fine.inside[v] != 0 ? half - std::sqrt(out[v]) : std::sqrt(values_[v]) - half;
  smoothen(values_, fine.size, threads);
  size_ = fine.size;
  lpsToIndex_ = fine.indexToLps.inverse();
}

double MaskDistance::at(const Vec3& point, Vec3& direction) const {
  const Vec3 wanted = lpsToIndex_ * point;
  std::array<std::size_t, 3> cell{};
  Vec3 inside, part;
  for (int axis = 0; axis < 3; ++axis) {
    inside[axis] = std::clamp(wanted[axis], 0.0, size_[static_cast<std::size_t>(axis)] - 1.0 - 1e-9);
    cell[static_cast<std::size_t>(axis)] = static_cast<std::size_t>(inside[axis]);
    part[axis] = inside[axis] - std::floor(inside[axis]);
  }
  const std::size_t row = std::size_t(size_[0]), slice = row * std::size_t(size_[1]);
  const float* at = values_.data() + cell[2] * slice + cell[1] * row + cell[0];
  // Trilinear: sum of d u v w over the corners, each factor part or 1 - part; the gradient has +-1 for one of
  // the factors, and becomes one in mm by the transposed matrix.
  double value = 0;
  Vec3 gradient = Vec3::Zero();
  for (int corner = 0; corner < 8; ++corner) {
    const bool i = (corner & 1) != 0, j = (corner & 2) != 0, k = (corner & 4) != 0;
    const double here = at[(i ? 1 : 0) + (j ? row : 0) + (k ? slice : 0)];
    const double u = i ? part[0] : 1 - part[0], v = j ? part[1] : 1 - part[1], w = k ? part[2] : 1 - part[2];
    value += here * u * v * w;
    gradient += here * Vec3((i ? v : -v) * w, (j ? u : -u) * w, (k ? u : -u) * v);
  }
  gradient = lpsToIndex_.linear().transpose() * gradient;
  const double length = gradient.norm();
  direction = gradient / std::max(length, 1e-9);
  // Straight on beyond the grid.
  return value + (lpsToIndex_.linear().inverse() * (wanted - inside)).dot(direction);
}

} // namespace viscera::tracking
