#include <cmath>

#include <gtest/gtest.h>

#include "bernstein_system.h"
#include "label_files.h"
#include "shapes.h"
#include "starved_zlib.h"
#include "temporary_folder.h"
#include "viscera/coordinates/systems.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/image_file.h"
#include "viscera/medical_io/warped_image.h"

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

class WarpedImage : public testing::Test {
protected:
  std::unique_ptr<deformation::InverseMap> mapFor(const Points& rest, const Points& pose) {
    return std::make_unique<deformation::InverseMap>(*system_, coordinates::HandleSet{rest, {}, {}}, pose,
                                                     coordinates::BindOptions{}, warpOptions(Vec3(2, 2, 2)),
                                                     progress_);
  }
  Scan warped(const Scan& scan, const Points& rest, const Points& pose) {
    return warpedScan(scan, {*mapFor(rest, pose), *system_}, report_, progress_);
  }
  std::shared_ptr<const coordinates::CoordinateSystem> system_ = coordinates::sCelestial();
  WarpReport report_;
  Progress progress_;
};

/// The largest difference from `expected` at the voxels around the middle.
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

// What interpolating the pattern once is off at most: for each axis an eighth of the squared step times the
// second derivative, and rounding. The reverse of a pose interpolates a second time.
constexpr double kInterpolation = 300 * (2.5 * 2.5 / 8) * (1.0 / 169 + 1.0 / 121 + 1.0 / 144) + 1;

TEST_F(WarpedImage, FollowsAnAffinePoseAndItsReverseBringsItBack) {
  const Scan scan = patternScan();
  const Eigen::Affine3d affine = someAffine();
  const Points rest = cube(60), pose = mapped(rest, affine);
  const Scan moved = warped(scan, rest, pose);
  EXPECT_LT(largestDifference(moved, [&](const Vec3& p) { return pattern(affine.inverse() * p); }),
            kInterpolation);
  EXPECT_EQ(report_.folded, 0U);
  EXPECT_GT(report_.moved, scan.voxelCount() / 2);
  EXPECT_LT(report_.largestErrorMm, kWarpAccuracy * 2);
  const Scan back = warped(moved, pose, rest);
  EXPECT_LT(largestDifference(back, pattern), 2 * kInterpolation) << "twice interpolated";
  EXPECT_GT(largestDifference(moved, pattern), 10 * kInterpolation) << "else nothing is proved";
}

/// A scan whose value is a coordinate of its place, mm: linear, so that interpolation adds nothing, and of
/// fractions, so that rounding adds nothing.
Scan rulerScan(int axis, double low, const Vec3& spacing) {
  Scan scan;
  scan.size = {36, 34, 36};
  scan.indexToLps.linear() = spacing.asDiagonal();
  scan.indexToLps.translation().setConstant(low);
  const auto& size = scan.size;
  std::vector<float> samples;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i)
        samples.push_back(float((scan.indexToLps * Vec3(i, j, k))[axis]));
  scan.samples = std::move(samples);
  return scan;
}

/// How far, in voxels, the places at rest that warped rulers read lie from where `inverse` has them, at
/// voxels from the tenth to the eighth last.
template <typename Inverse>
double largestVoxelError(const std::array<Scan, 3>& rulers, const Inverse& inverse) {
  double largest = 0;
  const Scan& first = rulers[0];
  for (int k = 10; k < first.size[2] - 8; ++k)
    for (int j = 10; j < first.size[1] - 8; ++j)
      for (int i = 10; i < first.size[0] - 8; ++i) {
        Vec3 read;
        for (int axis = 0; axis < 3; ++axis)
          read[axis] = rulers[std::size_t(axis)].value(i, j, k);
        largest = std::max(largest, (read - inverse(first.indexToLps * Vec3(i, j, k))).norm());
      }
  return largest / first.spacing().minCoeff();
}

TEST_F(WarpedImage, IsWithinATwentiethOfAVoxelOfTheInverseOfAnAffine) {
  const Points rest = cube(60), pose = mapped(rest, someAffine());
  std::array<Scan, 3> rulers;
  const auto map = mapFor(rest, pose);
  for (int axis = 0; axis < 3; ++axis)
    rulers[std::size_t(axis)] =
        warpedScan(rulerScan(axis, -35, Vec3(2, 2.5, 2)), {*map, *system_}, report_, progress_);
  EXPECT_LT(largestVoxelError(rulers, [](const Vec3& p) { return Vec3(someAffine().inverse() * p); }),
            kWarpAccuracy);
}

TEST_F(WarpedImage, IsWithinATwentiethOfAVoxelOfTheInverseOfASmoothDeformation) {
  const tests::BernsteinSystem system;
  const auto handles = tests::BernsteinSystem::lattice();
  constexpr double kBend = 25;
  const deformation::InverseMap map(system, handles, tests::bentPose(handles, kBend), {},
                                    warpOptions(Vec3(3, 3, 3)), progress_);
  std::array<Scan, 3> rulers;
  for (int axis = 0; axis < 3; ++axis)
    rulers[std::size_t(axis)] =
        warpedScan(rulerScan(axis, -3, Vec3(3, 3, 3)), {map, system}, report_, progress_);
  EXPECT_LT(
      largestVoxelError(
          rulers, [](const Vec3& p) { return Vec3(tests::analyticInverse(p.x(), kBend), p.y(), p.z()); }),
      kWarpAccuracy);
}

TEST_F(WarpedImage, DoesNotBendWhatDoesNotBend) {
  const tests::BernsteinSystem system;
  const auto handles = tests::BernsteinSystem::lattice();
  const deformation::InverseMap map(system, handles, tests::bentPose(handles, 25), {},
                                    warpOptions(Vec3(3, 3, 3)), progress_);
  const Vec3 middle(35, 50, 50);
  const auto bone = std::make_shared<const geometry::TriangleMesh>(tests::sphere(3, 15, middle));
  deformation::StiffBodies bodies({bone}, {}, progress_);
  const Points posed = bone->points.rowwise() + Eigen::RowVector3d(11, 0, 2);
  bodies.setPose({&posed}, map);
  const Scan warped = warpedScan(rulerScan(0, -3, Vec3(3, 3, 3)), {map, system, &bodies}, report_, progress_);
  int inside = 0;
  for (int k = 0; k < warped.size[2]; ++k)
    for (int j = 0; j < warped.size[1]; ++j)
      for (int i = 0; i < warped.size[0]; ++i) {
        const Vec3 place = warped.indexToLps * Vec3(i, j, k);
        if ((place - Vec3(11, 0, 2) - middle).norm() > 14.5)
          continue;
        ++inside;
        ASSERT_NEAR(warped.value(i, j, k), place.x() - 11, 1e-3) << place.transpose();
      }
  EXPECT_GT(inside, 300);
  EXPECT_LT(report_.largestErrorMm, 3 * kWarpAccuracy) << "of the tissue, not of the bone";
}

TEST_F(WarpedImage, StaysWhereNothingMoves) {
  const Scan scan = patternScan();
  const Points rest = cube(15);
  Points pose = rest;
  pose.row(7) += Eigen::RowVector3d(4, 3, 2);
  const Scan moved = warped(scan, rest, pose);
  EXPECT_EQ(moved.value(1, 1, 1), scan.value(1, 1, 1));
  EXPECT_GT(report_.moved, 0U);
  EXPECT_LT(report_.moved, scan.voxelCount());
  EXPECT_EQ(std::get<std::vector<std::int16_t>>(warped(scan, rest, rest).samples),
            std::get<std::vector<std::int16_t>>(scan.samples));
}

TEST_F(WarpedImage, LabelsMoveWithTheirNamesAndAreWritten) {
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
  const LabelMap warped = warpedLabelMap(map, {*mapFor(cube(38), pose), *system_}, report_, progress_);
  ASSERT_GE(warped.segments.size(), 1U);
  EXPECT_EQ(warped.segments[0].name, "liver");
  EXPECT_NEAR(double(warped.segments[0].voxels), double(map.segments[0].voxels),
              0.02 * double(map.segments[0].voxels));
  EXPECT_EQ(warped.segments[0].low[0], map.segments[0].low[0] + 5);
  for (const char* name : {"b.seg.nrrd", "b.nii.gz"}) {
    writeLabelMap(folder / name, warped);
    const LabelMap again = readLabelMap(folder / name, progress_);
    ASSERT_GE(again.segments.size(), 1U);
    EXPECT_EQ(again.segments[0].label, 3);
    EXPECT_EQ(again.segments[0].voxels, warped.segments[0].voxels);
    EXPECT_LT((again.indexToLps.matrix() - warped.indexToLps.matrix()).norm(), 1e-4);
  }
  EXPECT_EQ(readLabelMap(folder / "b.seg.nrrd", progress_).segments[0].name, "liver");
}

TEST(WrittenLabels, ThatNiftiCannotTellApartAreRefused) {
  tests::LabelImage image = tests::emptyLabels();
  const std::size_t voxels = image.voxels.size();
  image.voxels.assign(2 * voxels, 0);
  image.voxels[0] = image.voxels[2 * voxels - 1] = 1;
  const std::string second = "Segment1_ID:=b\nSegment1_Name:=cyst\nSegment1_Layer:=1\nSegment1_LabelValue:=";
  const tests::TemporaryFolder folder;
  Progress progress;
  const auto read = [&](const std::string& label) {
    return readLabelMap(
        folder.put("a.seg.nrrd", tests::nrrdFile(image, "left-posterior-superior",
                                                 "Segment0_ID:=a\nSegment0_Name:=kidney\nSegment0_Layer:=0\n"
                                                 "Segment0_LabelValue:=1\n" +
                                                     second + label + "\n",
                                                 2)),
        progress);
  };
  const LabelMap same = read("1");
  ASSERT_EQ(same.segments.size(), 2U);
  try {
    writeLabelMap(folder / "b.nii.gz", same);
    ADD_FAILURE() << "the cyst has become the kidney";
  } catch (const DataError& error) {
    EXPECT_NE(error.tryThis().english().find(".seg.nrrd"), std::string::npos) << error.what();
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "b.nii.gz"));
  writeLabelMap(folder / "b.seg.nrrd", same);
  EXPECT_EQ(readLabelMap(folder / "b.seg.nrrd", progress).segments.size(), 2U);
  image.voxels[2 * voxels - 1] = 2;
  const LabelMap other = read("2");
  ASSERT_EQ(other.segments.size(), 2U);
  writeLabelMap(folder / "b.nii.gz", other);
  EXPECT_EQ(readLabelMap(folder / "b.nii.gz", progress).segments.size(), 2U);
}

TEST(WrittenLabels, ThatZlibCannotPackLeaveTheOldFile) {
  tests::LabelImage image = tests::emptyLabels();
  image.at(1, 2, 3) = 1;
  const tests::TemporaryFolder folder;
  Progress progress;
  const LabelMap map = readLabelMap(folder.put("a.nrrd", tests::nrrdFile(image)), progress);
  const auto file = folder.put("b.nii.gz", "before");
  {
    const tests::StarvedZlib starved;
    EXPECT_THROW(writeLabelMap(file, map), std::bad_alloc);
  }
  EXPECT_EQ(tests::contentsOf(file), "before");
  writeLabelMap(file, map);
  EXPECT_EQ(readLabelMap(file, progress).segments.size(), 1U);
}

} // namespace
} // namespace viscera::medical_io
