#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include "viscera/medical_io/scan.h"

/// Interpolates values between voxels: the inner loops of all code that samples a scan.
namespace viscera::medical_io {

/// Whether a stored sample is a measured one.
template <class Sample>
class Measured {
public:
  explicit Measured(const std::optional<double>& padding) {
    constexpr double kLow = double(std::numeric_limits<Sample>::lowest());
    constexpr double kHigh = double(std::numeric_limits<Sample>::max());
    if (padding && *padding >= kLow && *padding <= kHigh)
      padding_ = static_cast<Sample>(*padding);
  }
  bool operator()(Sample sample) const {
    if constexpr (std::is_floating_point_v<Sample>)
      if (!std::isfinite(sample))
        return false;
    return !padding_ || sample != *padding_;
  }

private:
  std::optional<Sample> padding_;
};

/// The neighbours of a point along one axis, and how far it is from the first to the second.
struct Neighbours {
  std::size_t low = 0, high = 0;
  double part = 0;
};

/// None outside by more than half a voxel.
inline std::optional<Neighbours> neighboursAt(double index, int size) {
  if (!(index >= -0.5 && index <= size - 0.5))
    return std::nullopt;
  const double inside = std::clamp(index, 0.0, double(size - 1));
  const int low = std::min(static_cast<int>(inside), size - 1);
  return Neighbours{std::size_t(low), std::size_t(std::min(low + 1, size - 1)), inside - low};
}

/// Trilinear samples of a grid of values. The values outlive it.
template <class Sample>
class TrilinearSampler {
public:
  TrilinearSampler(const std::vector<Sample>& samples, const std::array<int, 3>& size,
                   const std::optional<double>& padding)
      : samples_(samples.data()), size_(size), measured_(padding), strideY_(std::size_t(size[0])),
        strideZ_(strideY_ * std::size_t(size[1])) {}

  /// The mean of the measured ones among the eight voxels around an index, as a sample; none when the nearest
  /// is not measured, and outside by more than half a voxel.
  std::optional<double> operator()(const Vec3& index) const {
    std::array<Neighbours, 3> at;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto found = neighboursAt(index[static_cast<Eigen::Index>(axis)], size_[axis]);
      if (!found)
        return std::nullopt;
      at[axis] = *found;
    }
    double sum = 0, weights = 0, heaviest = 0;
    bool nearestMeasured = false;
    for (unsigned corner = 0; corner < 8; ++corner) {
      const bool x = (corner & 1U) != 0, y = (corner & 2U) != 0, z = (corner & 4U) != 0;
      const double weight = (x ? at[0].part : 1 - at[0].part) * (y ? at[1].part : 1 - at[1].part) *
                            (z ? at[2].part : 1 - at[2].part);
      const Sample sample = samples_[(x ? at[0].high : at[0].low) + strideY_ * (y ? at[1].high : at[1].low) +
                                     strideZ_ * (z ? at[2].high : at[2].low)];
      const bool usable = measured_(sample);
      if (weight > heaviest) {
        heaviest = weight;
        nearestMeasured = usable;
      }
      if (usable) {
        sum += weight * double(sample);
        weights += weight;
      }
    }
    return nearestMeasured ? std::optional(sum / weights) : std::nullopt;
  }

private:
  const Sample* samples_;
  std::array<int, 3> size_;
  Measured<Sample> measured_;
  std::size_t strideY_, strideZ_;
};

} // namespace viscera::medical_io
