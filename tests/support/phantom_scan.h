#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "label_files.h"
#include "viscera/medical_io/scan.h"

/// Scans of which every value is known by its place in the patient: in memory, and on grids that become
/// files.
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

/// A voxel that differs from its neighbours.
struct ScanMarker {
  Vec3 lps;
  std::int16_t value;
};

inline const std::vector<ScanMarker>& scanMarkers() {
  static const std::vector<ScanMarker> kMarkers = {
      {{0, 0, 0}, 2001}, {{30, -12, 20}, 2002}, {{-6, 40, 8}, 2003}, {{18, 16, -24}, 2004}};
  return kMarkers;
}

/// The value everywhere but at markers; it rises differently along each axis.
inline double phantomValue(const Vec3& lps) {
  return 3 * lps.x() - 5 * lps.y() + 2 * lps.z() - 300;
}

/// A grid around the markers with steps of 3, 4 and 4 mm in the patient's x, y and z. Bit n of `flips`: axis
/// n runs the other way; `order` says which axis of the patient i, j and k run along.
inline LabelImage orientedPhantomGrid(int flips, const std::array<int, 3>& order) {
  const std::array<int, 3> counts = {21, 23, 17};
  const Vec3 steps(3, 4, 4), low(-21, -36, -36);
  LabelImage image;
  image.indexToLps.setIdentity();
  image.indexToLps.linear().setZero();
  Vec3 origin = low;
  for (int axis = 0; axis < 3; ++axis) {
    const int along = order[std::size_t(axis)];
    const int count = counts[std::size_t(along)];
    const bool flipped = (flips >> axis & 1) != 0;
    image.size[std::size_t(axis)] = count;
    image.indexToLps.linear()(along, axis) = flipped ? -steps[along] : steps[along];
    if (flipped)
      origin[along] += steps[along] * (count - 1);
  }
  image.indexToLps.translation() = origin;
  return image;
}

/// Fills a grid with the phantom's values; each marker goes to the voxel next to it.
inline void fillPhantom(LabelImage& image) {
  image.voxels.assign(std::size_t(image.size[0]) * std::size_t(image.size[1]) * std::size_t(image.size[2]),
                      0);
  for (int k = 0; k < image.size[2]; ++k)
    for (int j = 0; j < image.size[1]; ++j)
      for (int i = 0; i < image.size[0]; ++i)
        image.at(i, j, k) = std::int16_t(std::lround(phantomValue(image.indexToLps * Vec3(i, j, k))));
  for (const ScanMarker& marker : scanMarkers()) {
    const Vec3 index = image.indexToLps.inverse() * marker.lps;
    image.at(int(std::lround(index.x())), int(std::lround(index.y())), int(std::lround(index.z()))) =
        marker.value;
  }
}

/// A phantom and what it is called.
struct OrientedPhantom {
  std::string name;
  LabelImage image;
};

/// All eight directions of the axes, two orders of them, and one that is turned out of them.
inline std::vector<OrientedPhantom> orientedPhantoms() {
  std::vector<OrientedPhantom> list;
  for (int flips = 0; flips < 8; ++flips)
    list.push_back({"flips " + std::to_string(flips), orientedPhantomGrid(flips, {0, 1, 2})});
  list.push_back({"sagittal slices", orientedPhantomGrid(4, {1, 2, 0})});
  list.push_back({"coronal slices", orientedPhantomGrid(2, {0, 2, 1})});
  LabelImage oblique = orientedPhantomGrid(0, {0, 1, 2});
  const Eigen::AngleAxisd turn(0.5, Vec3(1, 2, 3).normalized());
  // Voxels stay where the markers are.
  const Vec3 still = scanMarkers()[0].lps;
  oblique.indexToLps = Eigen::Translation3d(still) * turn * Eigen::Translation3d(-still) * oblique.indexToLps;
  list.push_back({"oblique", oblique});
  for (OrientedPhantom& one : list)
    fillPhantom(one.image);
  return list;
}

} // namespace viscera::tests
