#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "label_files.h"

/// A small beating organ as label maps: muscle (3) around two cavities (1 and 2).
namespace viscera::tests {

/// One phase, `part` of the way through the beat.
inline LabelImage beatingLabels(double part, const Vec3& spacing = Vec3(2, 2, 2)) {
  const double squeeze = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * part);
  LabelImage image = emptyLabels({int(100 / spacing[0]), int(90 / spacing[1]), int(80 / spacing[2])});
  image.indexToLps = Eigen::Translation3d(-50, -45, -40) * Eigen::Scaling(spacing);
  const auto within = [&](const Vec3& at, const Vec3& center, const Vec3& radii) {
    return ((at - center).cwiseQuotient(radii)).squaredNorm() <= 1;
  };
  for (int k = 0; k < image.size[2]; ++k)
    for (int j = 0; j < image.size[1]; ++j)
      for (int i = 0; i < image.size[0]; ++i) {
        const Vec3 at = image.indexToLps * Vec3(i, j, k);
        if (within(at, Vec3(-11, 0, 0), Vec3(15 - 4 * squeeze, 17 - 4 * squeeze, 20 - 2 * squeeze)))
          image.at(i, j, k) = 1;
        else if (within(at, Vec3(17, 0, 0), Vec3(9 - 2 * squeeze, 13 - 3 * squeeze, 17 - 2 * squeeze)))
          image.at(i, j, k) = 2;
        else if (within(at, Vec3(0, 0, 0), Vec3(38 - 2 * squeeze, 30 - 2 * squeeze, 31 - 2 * squeeze)))
          image.at(i, j, k) = 3;
      }
  return image;
}

/// Names for these labels as 3D Slicer writes them, keys of a .seg.nrrd (`nrrdFile`).
inline const char* const kHeartKeys =
    "Segment0_ID:=S1\nSegment0_Name:=left ventricle of heart\nSegment0_LabelValue:=1\n"
    "Segment1_ID:=S2\nSegment1_Name:=right ventricle of heart\nSegment1_LabelValue:=2\n"
    "Segment2_ID:=S3\nSegment2_Name:=myocardium\nSegment2_LabelValue:=3\n";

/// Several phases in one NIfTI, time last; `step` in the unit that `units` says (0x38 of xyzt_units).
inline std::string nifti4d(const std::vector<LabelImage>& phases, double step, int units) {
  std::string bytes = niftiFile(phases.front());
  putBytes<std::int16_t>(bytes, 40, 4);
  putBytes<std::int16_t>(bytes, 48, std::int16_t(phases.size()));
  putBytes<float>(bytes, 92, float(step));
  bytes[123] = char(2 | units);
  for (std::size_t phase = 1; phase < phases.size(); ++phase)
    bytes += voxelBytes(phases[phase].voxels);
  return bytes;
}

/// A sequence as written by 3D Slicer: time is the first, fastest axis. `keys` as in `nrrdFile`.
inline std::string sequenceNrrd(const std::vector<LabelImage>& phases, const std::string& keys) {
  LabelImage all = phases.front();
  all.voxels.clear();
  for (std::size_t v = 0; v < phases.front().voxels.size(); ++v)
    for (const LabelImage& phase : phases)
      all.voxels.push_back(phase.voxels[v]);
  return nrrdFile(all, "right-anterior-superior", keys, int(phases.size()));
}

} // namespace viscera::tests
