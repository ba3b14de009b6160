#include "viscera/geometry/squared_distances.h"

#include <algorithm>

namespace viscera::geometry {
namespace {

/// The lower envelope of parabolas over one line of voxels; keeps its memory from line to line.
class Envelope {
public:
  explicit Envelope(std::size_t count) : values_(count), vertex_(count), from_(count + 1) {}

  /// Replaces the `count` values at `data`, `stride` apart, by `min_q (spacing (p - q))^2 + value_q`.
  void transform(float* data, std::size_t stride, std::size_t count, double spacing) {
    std::size_t parabolas = 0;
    const double square = spacing * spacing;
    for (std::size_t q = 0; q < count; ++q) {
      const double value = data[q * stride];
      values_[q] = value;
      if (value >= kNoneSquared)
        continue;
      double crossing = 0;
      while (parabolas > 0) {
        const std::size_t v = vertex_[parabolas - 1];
        // Two parabolas h^2 (p - q)^2 + f_q and h^2 (p - v)^2 + f_v meet at
        // p = ((f_q - f_v) / h^2 + q^2 - v^2) / (2 (q - v)); right of it that of q is lower. The one before
        // has no place left where this is not right of its own beginning.
        const auto here = static_cast<double>(q), there = static_cast<double>(v);
        crossing = ((value - values_[v]) / square + here * here - there * there) / (2 * (here - there));
        if (crossing > from_[parabolas - 1])
          break;
        --parabolas;
      }
      from_[parabolas] = parabolas == 0 ? -1 : crossing;
      vertex_[parabolas++] = q;
    }
    if (parabolas == 0)
      return;
    for (std::size_t p = 0, at = 0; p < count; ++p) {
      while (at + 1 < parabolas && from_[at + 1] < static_cast<double>(p))
        ++at;
      const double apart = static_cast<double>(p) - static_cast<double>(vertex_[at]);
      data[p * stride] = static_cast<float>(square * apart * apart + values_[vertex_[at]]);
    }
  }

private:
  std::vector<double> values_;
  std::vector<std::size_t> vertex_;
  std::vector<double> from_;
};

} // namespace

std::vector<float> squaredDistances(const std::vector<std::uint8_t>& mask, std::uint8_t value,
                                    const std::array<int, 3>& size, const Vec3& spacing,
                                    const std::array<bool, 3>& along, Threads threads) {
  constexpr Eigen::Index kLines = 64;
  std::vector<float> distances(mask.size());
  std::transform(mask.begin(), mask.end(), distances.begin(),
                 [&](std::uint8_t voxel) { return voxel == value ? 0.0F : kNoneSquared; });
  const std::array<std::size_t, 3> n = {std::size_t(size[0]), std::size_t(size[1]), std::size_t(size[2])};
  const std::array<std::size_t, 3> stride = {1, n[0], n[0] * n[1]};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!along[axis])
      continue;
    const std::size_t b = (axis + 1) % 3, c = (axis + 2) % 3;
    parallelRanges(
        static_cast<Eigen::Index>(n[b] * n[c]), kLines, threads, [&](Eigen::Index begin, Eigen::Index end) {
          Envelope envelope(n[axis]);
          for (auto line = static_cast<std::size_t>(begin); line < static_cast<std::size_t>(end); ++line)
            envelope.transform(distances.data() + line % n[b] * stride[b] + line / n[b] * stride[c],
                               stride[axis], n[axis], spacing[static_cast<int>(axis)]);
        });
  }
  return distances;
}

} // namespace viscera::geometry
