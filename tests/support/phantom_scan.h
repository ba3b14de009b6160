#pragma once

#include <cmath>

#include "viscera/medical_io/scan.h"

/// Scans with known values, for tests.
namespace viscera::tests {

/// A scan of 16-bit samples over a box whose first voxel's centre is `origin`; the value at a voxel is
/// `valueAt(place in mm LPS)`, rounded. `axes` are the directions of i, j, k, as columns.
template <class ValueAt>
medical_io::Scan phantomScan(const std::array<int, 3>& size, const Vec3& spacing, const Vec3& origin,
                             ValueAt valueAt, const Eigen::Matrix3d& axes = Eigen::Matrix3d::Identity()) {
  medical_io::Scan scan;
  scan.size = size;
  scan.indexToLps.linear() = axes * spacing.asDiagonal();
  scan.indexToLps.translation() = origin;
  scan.modality = "CT";
  scan.unit = "HU";
  scan.intercept = -1024;
  std::vector<std::int16_t> samples(scan.voxelCount());
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i)
        samples[scan.indexOf(i, j, k)] =
            static_cast<std::int16_t>(std::lround(valueAt(Vec3(scan.indexToLps * Vec3(i, j, k))) + 1024));
  scan.samples = std::move(samples);
  return scan;
}

/// A value that differs along every axis: linear, so that linear interpolation is exact but for rounding.
inline double slope(const Vec3& place) {
  return 2 * place.x() - 3 * place.y() + 5 * place.z();
}

/// 100 in a ball, -50 around it.
inline auto ballValue(const Vec3& center, double radius) {
  return [=](const Vec3& place) { return (place - center).norm() < radius ? 100.0 : -50.0; };
}

} // namespace viscera::tests
