#include "viscera/medical_io/region_statistics.h"

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "phantom_scan.h"

namespace viscera::medical_io {
namespace {

const Vec3 kMiddle(7, -12, 40);

/// A grid along the patient's axes, one that is mirrored and has its axes in another order, an oblique one
/// and one that is sheared besides.
std::vector<Eigen::Matrix3d> someAxes() {
  Eigen::Matrix3d mirrored = Eigen::Matrix3d::Zero();
  mirrored(2, 0) = mirrored(0, 1) = mirrored(1, 2) = -1;
  const Eigen::Matrix3d oblique = Eigen::AngleAxisd(0.5, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  Eigen::Matrix3d sheared = oblique;
  sheared.col(2) = (sheared.col(2) + 0.3 * sheared.col(1)).eval();
  return {Eigen::Matrix3d::Identity(), mirrored, oblique, sheared};
}

/// Around (7, -12, 40), as far as a ball of 25 mm.
template <class ValueAt>
Scan scanAround(const Eigen::Matrix3d& axes, ValueAt valueAt) {
  const Vec3 spacing(1, 1.5, 2);
  return tests::phantomScan({61, 51, 41}, spacing, kMiddle - axes * spacing.asDiagonal() * Vec3(30, 25, 20),
                            valueAt, axes);
}

/// Every voxel's centre, held against the sphere one by one.
RegionStatistics oneByOne(const Scan& scan, const std::function<bool(const Vec3& index)>& isIn) {
  std::vector<double> values;
  for (int k = 0; k < scan.size[2]; ++k)
    for (int j = 0; j < scan.size[1]; ++j)
      for (int i = 0; i < scan.size[0]; ++i)
        if (isIn(Vec3(i, j, k)))
          values.push_back(scan.value(i, j, k));
  RegionStatistics all;
  all.count = values.size();
  all.minimum = std::numeric_limits<double>::infinity();
  all.maximum = -all.minimum;
  for (const double value : values) {
    all.mean += value / double(values.size());
    all.minimum = std::min(all.minimum, value);
    all.maximum = std::max(all.maximum, value);
  }
  double squares = 0;
  for (const double value : values)
    squares += (value - all.mean) * (value - all.mean);
  all.deviation = std::sqrt(squares / double(values.size() - 1));
  return all;
}

void expectSame(const RegionStatistics& a, const RegionStatistics& b) {
  EXPECT_EQ(a.count, b.count);
  EXPECT_NEAR(a.mean, b.mean, 1e-9 * (1 + std::abs(b.mean)));
  EXPECT_NEAR(a.deviation, b.deviation, 1e-9 * (1 + b.deviation));
  EXPECT_EQ(a.minimum, b.minimum);
  EXPECT_EQ(a.maximum, b.maximum);
}

TEST(RegionStatistics, OfASphereAreThoseOfTheVoxelsWithTheirCentreInIt) {
  for (const Eigen::Matrix3d& axes : someAxes()) {
    const Scan scan = scanAround(axes, tests::slope);
    const SphereRegion sphere{kMiddle + Vec3(3.2, -1.7, 2.6), 13.4};
    const RegionStatistics found = statisticsOf(scan, sphere);
    expectSame(found, oneByOne(scan, [&](const Vec3& index) {
                 return (scan.indexToLps * index - sphere.center).norm() <= sphere.radius;
               }));
    const double voxelMl = std::abs(scan.indexToLps.linear().determinant()) / 1000;
    EXPECT_NEAR(double(found.count) * voxelMl, sphere.volumeMl(), 0.02 * sphere.volumeMl());
    // A linear value has the middle's as its mean.
    EXPECT_NEAR(found.mean, tests::slope(sphere.center), 1);
  }
}

TEST(RegionStatistics, OfABallOfOneValueHaveNoDeviationAndAtItsBorderBothValues) {
  for (const Eigen::Matrix3d& axes : someAxes()) {
    const Scan scan = scanAround(axes, tests::ballValue(kMiddle, 20));
    expectSame(statisticsOf(scan, SphereRegion{kMiddle, 19.9}),
               {statisticsOf(scan, SphereRegion{kMiddle, 19.9}).count, 100, 0, 100, 100});
    // The plane through the border's middle: half a ball of 100, half of -50.
    const RegionStatistics both = statisticsOf(scan, SphereRegion{kMiddle + Vec3(20, 0, 0), 4});
    EXPECT_EQ(both.minimum, -50);
    EXPECT_EQ(both.maximum, 100);
    EXPECT_NEAR(both.mean, 25, 15);
    EXPECT_NEAR(both.deviation, 75, 2);
  }
}

TEST(RegionStatistics, OfARectangleAreThoseOfTheLayerThatItsPlaneLiesIn) {
  const Scan scan = tests::phantomScan({10, 12, 8}, Vec3(2, 1, 3), Vec3(100, -50, 20), [](const Vec3& p) {
    return 1000 * (p.z() - 20) / 3 + 10 * (p.x() - 100) / 2 + (p.y() + 50);
  });
  // Columns 2 to 4, rows 3 to 6, in layer 5 (35 mm); the plane a millimetre beside the centres.
  const RectangleRegion rectangle{Vec3(103.1, -47.4, 36), Vec3(5.8, 0, 0), Vec3(0, 3.8, 0)};
  const RegionStatistics found = statisticsOf(scan, rectangle);
  EXPECT_EQ(found.count, 12u);
  EXPECT_NEAR(found.mean, 5000 + 30 + 4.5, 1e-9);
  EXPECT_EQ(found.minimum, 5023);
  EXPECT_EQ(found.maximum, 5046);
  // Columns spread by sqrt(2/3) * 10, rows by sqrt(5/4), of the twelve as a sample.
  EXPECT_NEAR(found.deviation, std::sqrt((200.0 / 3 + 1.25) * 12 / 11), 1e-9);
  EXPECT_NEAR(rectangle.areaMm2(), 22.04, 1e-9);
  // Between two layers the later one; sides in any direction.
  EXPECT_EQ(
      statisticsOf(scan, RectangleRegion{Vec3(103.1, -47.4, 36.5), Vec3(5.8, 0, 0), Vec3(0, 3.8, 0)}).minimum,
      6023);
  expectSame(statisticsOf(scan, RectangleRegion{Vec3(108.9, -43.6, 36), Vec3(0, -3.8, 0), Vec3(-5.8, 0, 0)}),
             found);
}

TEST(RegionStatistics, OfARectangleInAnObliqueScanCountEachVoxelOfThePlaneOnce) {
  for (const Eigen::Matrix3d& axes : someAxes())
    for (int axis = 0; axis < 3; ++axis) {
      const Scan scan = scanAround(axes, tests::slope);
      const Vec3 first = 21.3 * Vec3::Unit((axis + 1) % 3), second = 16.9 * Vec3::Unit((axis + 2) % 3);
      const RectangleRegion rectangle{kMiddle - 0.5 * (first + second) + 0.37 * Vec3::Unit(axis), first,
                                      second};
      const RegionStatistics found = statisticsOf(scan, rectangle);
      const Vec3 normal = Vec3::Unit(axis);
      const Eigen::Affine3d toIndex = scan.indexToLps.inverse();
      expectSame(found, oneByOne(scan, [&](const Vec3& index) {
                   Vec3 foot = scan.indexToLps * index;
                   foot[axis] = rectangle.corner[axis];
                   const Vec3 nearest = (toIndex * foot).array().round();
                   const Vec3 from = foot - rectangle.corner;
                   return nearest == index && from.dot(first) >= 0 && from.dot(second) >= 0 &&
                          from.dot(first) <= first.squaredNorm() && from.dot(second) <= second.squaredNorm();
                 }));
      // As many as the plane's area asks for: of a voxel its part through the plane.
      EXPECT_GT(found.count, 60u);
      EXPECT_NEAR(found.mean, tests::slope(kMiddle + 0.37 * normal), 4);
    }
}

TEST(RegionStatistics, LeavePaddingOutAndAreEmptyBesideTheScan) {
  Scan scan = tests::phantomScan({8, 8, 8}, Vec3::Ones(), Vec3::Zero(),
                                 [](const Vec3& p) { return p.x() < 3.5 ? 50.0 : -3024.0; });
  scan.padding = -2000;
  expectSame(statisticsOf(scan, SphereRegion{Vec3(3.5, 3.5, 3.5), 50}), {256, 50, 0, 50, 50});
  EXPECT_EQ(statisticsOf(scan, RectangleRegion{Vec3(4, 0, 3), Vec3(3, 0, 0), Vec3(0, 7, 0)}),
            RegionStatistics());
  for (const Vec3& away : {Vec3(50, 0, 0), Vec3(-1e9, 1e9, 3), Vec3(3, 3, -30)}) {
    EXPECT_EQ(statisticsOf(scan, SphereRegion{away, 5}).count, 0u);
    EXPECT_EQ(statisticsOf(scan, RectangleRegion{away, Vec3(5, 0, 0), Vec3(0, 5, 0)}).count, 0u);
  }
  EXPECT_EQ(statisticsOf(scan, RectangleRegion{Vec3(1, 1, 1), Vec3(3, 0, 0), Vec3::Zero()}).count, 0u);
  EXPECT_EQ(statisticsOf(Scan(), SphereRegion{Vec3::Zero(), 5}).count, 0u);
}

TEST(RegionStatistics, LoseNoDigitsToALargeMeanAndTurnWithANegativeSlope) {
  Scan scan = tests::phantomScan({40, 40, 40}, Vec3::Ones(), Vec3::Zero(), [](const Vec3&) { return 0.0; });
  std::vector<float> samples(scan.voxelCount());
  for (std::size_t v = 0; v < samples.size(); ++v)
    samples[v] = v % 2 == 0 ? 8e6F : 8e6F + 1;
  scan.samples = samples;
  scan.slope = -2;
  scan.intercept = 5;
  const RegionStatistics found = statisticsOf(scan, SphereRegion{Vec3(20, 20, 20), 100});
  EXPECT_EQ(found.count, 64000u);
  EXPECT_NEAR(found.mean, -16e6 - 1 + 5, 1e-6);
  EXPECT_NEAR(found.deviation, std::sqrt(64000.0 / 63999), 1e-9);
  EXPECT_EQ(found.minimum, -16e6 - 2 + 5);
  EXPECT_EQ(found.maximum, -16e6 + 5);
}

TEST(RegionStatistics, AreTheSameWithOneThreadAndWithFour) {
  const Scan scan = scanAround(someAxes().back(), tests::slope);
  const SphereRegion sphere{kMiddle, 15};
  EXPECT_EQ(statisticsOf(scan, sphere, {1}), statisticsOf(scan, sphere, {4}));
}

} // namespace
} // namespace viscera::medical_io
