#include <cmath>

#include <gtest/gtest.h>

#include "label_files.h"
#include "temporary_folder.h"
#include "viscera/coordinates/celestial/s_celestial.h"
#include "viscera/medical_io/bent_image.h"
#include "viscera/medical_io/image_file.h"

namespace viscera::medical_io {
namespace {

/// Smooth at the size of voxels, so that interpolation's error is known: below 8 for waves of 300 over 40 mm.
double pattern(const Vec3& p) {
  return 300 * (std::sin(p.x() / 13) + std::cos(p.y() / 11) + std::sin(p.z() / 12 + 1));
}

Scan patternScan() {
  Scan scan;
  scan.size = {44, 40, 36};
  scan.indexToLps.linear() =
      Eigen::AngleAxisd(0.2, Vec3(1, 1, 0).normalized()) * Vec3(2, 2.2, 2.5).asDiagonal();
  scan.indexToLps.translation() = -(scan.indexToLps.linear() * Vec3(22, 20, 18));
  std::vector<std::int16_t> samples;
  for (int k = 0; k < scan.size[2]; ++k)
    for (int j = 0; j < scan.size[1]; ++j)
      for (int i = 0; i < scan.size[0]; ++i)
        samples.push_back(std::int16_t(std::lround(pattern(scan.indexToLps * Vec3(i, j, k)))));
  scan.samples = std::move(samples);
  return scan;
}

Points cube(double half) {
  Points corners(8, 3);
  for (int c = 0; c < 8; ++c)
    corners.row(c) << (c & 1 ? half : -half), (c & 2 ? half : -half), (c & 4 ? half : -half);
  return corners;
}

Points mapped(const Points& points, const Eigen::Affine3d& affine) {
  return (points * affine.linear().transpose()).rowwise() + affine.translation().transpose();
}

Eigen::Affine3d someAffine() {
  Eigen::Affine3d affine = Eigen::Affine3d::Identity();
  affine.linear() << 1.06, 0.08, 0, -0.1, 0.95, 0.05, 0, 0.06, 1.02;
  affine.translation() << 3, -4, 2;
  return affine;
}

class BentImage : public testing::Test {
protected:
  std::unique_ptr<deformation::InverseMap> mapFor(const Points& rest, const Points& pose) {
    return std::make_unique<deformation::InverseMap>(
        coordinates::SCelestial(), coordinates::HandleSet{rest, {}, {}}, pose, coordinates::BindOptions{},
        deformation::InverseMapOptions{.accuracyMm = 0.05}, progress_);
  }
  Progress progress_;
};

/// The largest difference from `expected` at the voxels around the middle, and how steep the pattern is.
template <typename Expected>
double largestDifference(const Scan& scan, const Expected& expected) {
  double largest = 0;
  for (int k = 9; k < 27; ++k)
    for (int j = 10; j < 30; ++j)
      for (int i = 11; i < 33; ++i)
        largest =
            std::max(largest, std::abs(scan.value(i, j, k) - expected(scan.indexToLps * Vec3(i, j, k))));
  return largest;
}

TEST_F(BentImage, FollowsAnAffinePoseExactlyAndItsReverseBringsItBack) {
  const Scan scan = patternScan();
  const Eigen::Affine3d affine = someAffine();
  const Points rest = cube(60), pose = mapped(rest, affine);
  const auto map = mapFor(rest, pose);
  BendReport report;
  const Scan bent = bentScan(scan, *map, report, progress_);
  // Interpolation alone: h^2 / 8 times the second derivative in each axis, and rounding.
  constexpr double kInterpolation = 300 * (2.5 * 2.5 / 8) * (1.0 / 169 + 1.0 / 121 + 1.0 / 144) + 1;
  EXPECT_LT(largestDifference(bent, [&](const Vec3& p) { return pattern(affine.inverse() * p); }),
            kInterpolation);
  EXPECT_EQ(report.folded, 0U);
  EXPECT_GT(report.moved, scan.voxelCount() / 2);
  // A twentieth of a voxel.
  EXPECT_LT(map->residualMm(coordinates::SCelestial(), report.posed, report.rest, progress_), 0.05 * 2);
  const Scan back = bentScan(bent, *mapFor(pose, rest), report, progress_);
  EXPECT_LT(largestDifference(back, pattern), 2 * kInterpolation) << "twice interpolated";
}

TEST_F(BentImage, StaysWhereNothingMoves) {
  const Scan scan = patternScan();
  const Points rest = cube(15);
  Points pose = rest;
  pose.row(7) += Eigen::RowVector3d(4, 3, 2);
  BendReport report;
  const Scan bent = bentScan(scan, *mapFor(rest, pose), report, progress_);
  EXPECT_EQ(bent.value(1, 1, 1), scan.value(1, 1, 1));
  EXPECT_GT(report.moved, 0U);
  EXPECT_LT(report.moved, scan.voxelCount());
  const Scan atRest = bentScan(scan, *mapFor(rest, rest), report, progress_);
  EXPECT_EQ(std::get<std::vector<std::int16_t>>(atRest.samples),
            std::get<std::vector<std::int16_t>>(scan.samples));
}

TEST_F(BentImage, LabelsMoveWithTheirNamesAndAreWritten) {
  tests::LabelImage image = tests::emptyLabels({40, 40, 40});
  image.indexToLps.linear() *= 2;
  image.indexToLps.translation().setConstant(-40);
  tests::addBall(image, {20, 20, 20}, 8, 3);
  image.at(1, 1, 1) = 9;
  const tests::TemporaryFolder folder;
  const LabelMap map =
      readLabelMap(folder.put("a.nrrd", tests::nrrdFile(image, "left-posterior-superior",
                                                        "Segment0_ID:=s\nSegment0_Name:=liver\n"
                                                        "Segment0_LabelValue:=3\n")),
                   progress_);
  Points pose = cube(38);
  pose.col(0).array() += 10;
  BendReport report;
  const LabelMap bent = bentLabelMap(map, *mapFor(cube(38), pose), report, progress_);
  ASSERT_GE(bent.segments.size(), 1U);
  EXPECT_EQ(bent.segments[0].name, "liver");
  EXPECT_NEAR(double(bent.segments[0].voxels), double(map.segments[0].voxels),
              0.02 * double(map.segments[0].voxels));
  EXPECT_EQ(bent.segments[0].low[0], map.segments[0].low[0] + 5);
  for (const char* name : {"b.seg.nrrd", "b.nii.gz"}) {
    writeLabelMap(folder / name, bent);
    const LabelMap again = readLabelMap(folder / name, progress_);
    ASSERT_GE(again.segments.size(), 1U);
    EXPECT_EQ(again.segments[0].label, 3);
    EXPECT_EQ(again.segments[0].voxels, bent.segments[0].voxels);
    EXPECT_LT((again.indexToLps.matrix() - bent.indexToLps.matrix()).norm(), 1e-4);
  }
  EXPECT_EQ(readLabelMap(folder / "b.seg.nrrd", progress_).segments[0].name, "liver");
}

} // namespace
} // namespace viscera::medical_io
