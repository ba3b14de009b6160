#include "viscera/tracking/mask.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "viscera/geometry/squared_distances.h"

namespace viscera::tracking {
namespace {

constexpr double kThick = 2;
/// A slice without a voxel inside is taken as this far from one, mm.
constexpr double kFarMm = 1e3;
/// Part of a voxel: rays do not run exactly through corners, which masks and surfaces made of them share.
constexpr double kAside = 3.1e-7;

/// Within the slices across `axis`, negative inside, mm.
std::vector<float> distancesInSlices(const Mask& mask, int axis) {
  std::array<bool, 3> along = {true, true, true};
  along[static_cast<std::size_t>(axis)] = false;
  const auto to = [&](std::uint8_t value) {
    return geometry::squaredDistances(mask.inside, value, mask.size, mask.spacing(), along, Threads{1});
  };
  std::vector<float> distances = to(1);
  const std::vector<float> out = to(0);
  for (std::size_t v = 0; v < distances.size(); ++v)
    distances[v] = static_cast<float>(std::min(std::sqrt(double(distances[v])), kFarMm) -
                                      std::min(std::sqrt(double(out[v])), kFarMm));
  return distances;
}

/// Where along the ray through row (j, k) the triangle is crossed; false when it is not. `a`, `b`, `c` are in
/// voxels.
bool crossing(const Vec3& a, const Vec3& b, const Vec3& c, double j, double k, double& at) {
  // Twice the areas that the row's place (j, k) makes with the edges, across the rows: barycentric
  // coordinates but for their sum. All of one sign means inside.
  const auto side = [&](const Vec3& p, const Vec3& q) {
    return (q[1] - p[1]) * (k - p[2]) - (q[2] - p[2]) * (j - p[1]);
  };
  const double u = side(b, c), v = side(c, a), w = side(a, b);
  if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) || u + v + w == 0)
    return false;
  at = (u * a[0] + v * b[0] + w * c[0]) / (u + v + w);
  return true;
}

} // namespace

std::int64_t Mask::count() const {
  return std::accumulate(inside.begin(), inside.end(), std::int64_t{0});
}

double Mask::volumeMl() const {
  return static_cast<double>(count()) * std::abs(indexToLps.linear().determinant()) / kMm3PerMl;
}

VoxelRange rangeOf(const Mask& mask) {
  VoxelRange range{mask.size, {-1, -1, -1}};
  std::size_t voxel = 0;
  for (int k = 0; k < mask.size[2]; ++k)
    for (int j = 0; j < mask.size[1]; ++j)
      for (int i = 0; i < mask.size[0]; ++i, ++voxel) {
        if (mask.inside[voxel] == 0)
          continue;
        const std::array<int, 3> at = {i, j, k};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          range.low[axis] = std::min(range.low[axis], at[axis]);
          range.high[axis] = std::max(range.high[axis], at[axis]);
        }
      }
  return range;
}

Mask cropped(const Mask& mask, const VoxelRange& range) {
  Mask result;
  for (std::size_t axis = 0; axis < 3; ++axis)
    result.size[axis] = range.high[axis] - range.low[axis] + 1;
  result.indexToLps = mask.indexToLps * Eigen::Translation3d(range.low[0], range.low[1], range.low[2]);
  result.inside.assign(
      std::size_t(result.size[0]) * std::size_t(result.size[1]) * std::size_t(result.size[2]), 0);
  const int first = std::max(0, range.low[0]), last = std::min(mask.size[0] - 1, range.high[0]);
  for (int k = std::max(0, range.low[2]); k <= std::min(mask.size[2] - 1, range.high[2]); ++k)
    for (int j = std::max(0, range.low[1]); j <= std::min(mask.size[1] - 1, range.high[1]); ++j)
      if (first <= last)
        std::copy_n(mask.inside.begin() + static_cast<std::ptrdiff_t>(mask.indexOf(first, j, k)),
                    last - first + 1,
                    result.inside.begin() + static_cast<std::ptrdiff_t>(result.indexOf(
                                                first - range.low[0], j - range.low[1], k - range.low[2])));
  return result;
}

int thickAxis(const Mask& mask) {
  const Vec3 spacing = mask.spacing();
  int axis = 0;
  spacing.maxCoeff(&axis);
  const double across = std::max(spacing[(axis + 1) % 3], spacing[(axis + 2) % 3]);
  return spacing[axis] > kThick * across && mask.size[static_cast<std::size_t>(axis)] > 1 ? axis : -1;
}

Mask betweenSlices(const Mask& mask) {
  const int axis = thickAxis(mask);
  const VoxelRange filled = rangeOf(mask);
  if (axis < 0 || filled.high[0] < filled.low[0])
    return mask;
  const auto a = static_cast<std::size_t>(axis);
  const Vec3 spacing = mask.spacing();
  const double step = std::min(spacing[(axis + 1) % 3], spacing[(axis + 2) % 3]) / spacing[axis];
  const std::vector<float> distances = distancesInSlices(mask, axis);
  Mask result;
  result.size = mask.size;
  result.size[a] = static_cast<int>(std::ceil(mask.size[a] / step));
  const double firstSlice = 0.5 * step - 0.5;
  Vec3 scale = Vec3::Ones(), shift = Vec3::Zero();
  scale[axis] = step;
  shift[axis] = firstSlice;
  result.indexToLps = mask.indexToLps * Eigen::Translation3d(shift) * Eigen::Scaling(scale);
  result.inside.assign(
      std::size_t(result.size[0]) * std::size_t(result.size[1]) * std::size_t(result.size[2]), 0);
  std::size_t voxel = 0;
  for (int k = 0; k < result.size[2]; ++k)
    for (int j = 0; j < result.size[1]; ++j)
      for (int i = 0; i < result.size[0]; ++i, ++voxel) {
        std::array<int, 3> at = {i, j, k};
        // d(z) = (1 - t) d_k + t d_k+1 between the slices' own signed distances: the outline moves evenly
        // from one to the next (shape-based interpolation).
        const double slice = firstSlice + at[a] * step;
        if (slice < filled.low[a] - 0.5 || slice > filled.high[a] + 0.5)
          continue;
        const double clamped = std::clamp(slice, double(filled.low[a]), double(filled.high[a]));
        at[a] = std::clamp(static_cast<int>(clamped), 0, mask.size[a] - 2);
        const double part = clamped - at[a];
        const double low = distances[mask.indexOf(at[0], at[1], at[2])];
        ++at[a];
        const double high = distances[mask.indexOf(at[0], at[1], at[2])];
        result.inside[voxel] = (1 - part) * low + part * high < 0 ? 1 : 0;
      }
  return result;
}

Mask voxelised(const geometry::TriangleMesh& surface, const Mask& grid) {
  const std::size_t voxels =
      std::size_t(grid.size[0]) * std::size_t(grid.size[1]) * std::size_t(grid.size[2]);
  Mask result{grid.size, grid.indexToLps, std::vector<std::uint8_t>(voxels, 0)};
  const Eigen::Affine3d toIndex = grid.indexToLps.inverse();
  Points points(surface.points.rows(), 3);
  for (Eigen::Index v = 0; v < points.rows(); ++v)
    points.row(v) = (toIndex * surface.points.row(v).transpose()).transpose();
  // The places where the surface is crossed, by row of voxels.
  std::vector<std::vector<double>> rows(std::size_t(grid.size[1]) * std::size_t(grid.size[2]));
  for (Eigen::Index t = 0; t < surface.triangles.rows(); ++t) {
    const Vec3 a = points.row(surface.triangles(t, 0)), b = points.row(surface.triangles(t, 1)),
               c = points.row(surface.triangles(t, 2));
    const Vec3 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    for (int k = std::max(0, int(std::floor(low[2])));
         k <= std::min(grid.size[2] - 1, int(std::ceil(high[2]))); ++k)
      for (int j = std::max(0, int(std::floor(low[1])));
           j <= std::min(grid.size[1] - 1, int(std::ceil(high[1]))); ++j)
        if (double at = 0; crossing(a, b, c, j + kAside, k + 1.7 * kAside, at))
          rows[std::size_t(k) * std::size_t(grid.size[1]) + std::size_t(j)].push_back(at);
  }
  for (std::size_t row = 0; row < rows.size(); ++row) {
    std::vector<double>& crossings = rows[row];
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const int first = std::max(0, static_cast<int>(std::ceil(crossings[i])));
      const int last = std::min(grid.size[0] - 1, static_cast<int>(std::floor(crossings[i + 1])));
      for (int voxel = first; voxel <= last; ++voxel)
        result.inside[row * std::size_t(grid.size[0]) + std::size_t(voxel)] = 1;
    }
  }
  return result;
}

double diceOf(const Mask& a, const Mask& b) {
  // 2 |A and B| / (|A| + |B|).
  std::int64_t both = 0, all = 0;
  for (std::size_t v = 0; v < a.inside.size(); ++v) {
    both += a.inside[v] & b.inside[v];
    all += a.inside[v] + b.inside[v];
  }
  return all == 0 ? 1 : 2 * static_cast<double>(both) / static_cast<double>(all);
}

} // namespace viscera::tracking
