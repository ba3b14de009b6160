#include <gtest/gtest.h>

#include "thick_cylinder.h"
#include "viscera/core/error.h"
#include "viscera/strain/material_contour.h"

namespace viscera::strain {
namespace {

TEST(MaterialContour, AcrossATubeIsClosedAndGoesWithItsMaterial) {
  const geometry::TriangleMesh tube = tests::closedTube(20, 0, 90, 64, 30);
  const geometry::Plane plane{Vec3(0, 0, 41), Vec3::UnitZ()};
  const auto lines = cutContours(tube.points, tube.triangles, {}, plane);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_TRUE(lines.front().closed);
  const double circle = 2 * std::numbers::pi * 20;
  EXPECT_NEAR(lines.front().lengthAt(tube.points), circle, 0.003 * circle);
  const tests::CylinderMotion motion{{}, 14, 0.85, 0};
  EXPECT_NEAR(lines.front().lengthAt(motion(tube.points)) / lines.front().lengthAt(tube.points), 14.0 / 20,
              1e-10);
}

TEST(MaterialContour, OverTheApexEndsAtTheRimThatIsLeftOut) {
  const geometry::TriangleMesh cavity = tests::ventricle(20, 80);
  std::vector<bool> cap(static_cast<std::size_t>(cavity.triangles.rows()));
  for (Eigen::Index t = 0; t < cavity.triangles.rows(); ++t)
    cap[static_cast<std::size_t>(t)] = (cavity.triangles.row(t).array() == 48 * 40).any();
  const auto lines =
      cutContours(cavity.points, cavity.triangles, cap, {Vec3::Zero(), Vec3(0.3, 1, 0).normalized()});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_FALSE(lines.front().closed);
  const Points line = lines.front().at(cavity.points);
  EXPECT_NEAR(line(0, 2), 0, 1e-9);
  EXPECT_NEAR(line(line.rows() - 1, 2), 0, 1e-9);
  EXPECT_NEAR(line.col(2).maxCoeff(), 80, 0.2);
}

TEST(MaterialContour, ThroughVerticesHasTheirLength) {
  const Points points = (Points(3, 3) << 0, 0, 0, 3, 0, 0, 3, 4, 0).finished();
  EXPECT_DOUBLE_EQ(MaterialContour::through({0, 1, 2}, false).lengthAt(points), 7);
  EXPECT_DOUBLE_EQ(MaterialContour::through({0, 1, 2}, true).lengthAt(points), 12);
}

} // namespace
} // namespace viscera::strain
