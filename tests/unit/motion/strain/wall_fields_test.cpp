#include <algorithm>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "held_value.h"
#include "thick_cylinder.h"
#include "viscera/core/error.h"
#include "viscera/strain/wall_fields.h"

namespace viscera::strain {
namespace {

/// The wall of a thick cylinder with its axes as they are found.
struct FoundWall {
  tests::ThickCylinder tube;
  deformation::WitnessMesh mesh = tests::tubeWall(tube, 48, 8, 30);
  geometry::TriangleMesh inner = tests::closedTube(tube.inner, 0, tube.length, 48, 30);
  geometry::TriangleMesh outer = tests::closedTube(tube.outer, 0, tube.length, 48, 30);
  HeartAxes axes{Vec3::Zero(), Vec3(0, 0, 90), Vec3::UnitX()};
  WallPoints points;

  FoundWall() {
    std::vector<bool> cap(static_cast<std::size_t>(inner.triangles.rows()));
    for (Eigen::Index t = 0; t < inner.triangles.rows(); ++t)
      cap[static_cast<std::size_t>(t)] = (inner.triangles.row(t).array() >= 48 * 31).any();
    Progress progress;
    points = wallPoints(mesh, {&inner, &outer, nullptr}, axes, cap, progress);
  }
};

TEST(WallFields, AreTheLogarithmOfTheRadiusAcrossAThickCylinder) {
  const FoundWall wall;
  ASSERT_GT(wall.points.count(), 5000);
  for (Eigen::Index i = 0; i < wall.points.count(); ++i) {
    const Vec3 place = wall.mesh.points.row(wall.points.rows[static_cast<std::size_t>(i)]);
    const double radius = std::hypot(place.x(), place.y());
    EXPECT_NEAR(wall.points.depth[i], std::log(radius / 20) / std::log(32.0 / 20), 0.01);
  }
}

/// The closed form, with axes found on the tetrahedra.
TEST(WallFields, GiveTheStrainOfACylinderThatTwistsAndInflatesToAThousandth) {
  const FoundWall wall;
  const tests::CylinderMotion motion{wall.tube, 14, 0.85, 0.004};
  tests::HeldValue held("the same cylinder, axes found on its tetrahedra", 1e-3);
  for (Eigen::Index i = 0; i < wall.points.count(); ++i) {
    const Vec3 place = wall.mesh.points.row(wall.points.rows[static_cast<std::size_t>(i)]);
    const double radius = std::hypot(place.x(), place.y());
    const WallStrain strain =
        strainAlong(motion.gradientAt(place), wall.points.axes[static_cast<std::size_t>(i)]);
    for (const double error :
         {strain.radial - motion.radialStrain(radius), strain.circumferential - motion.aroundStrain(radius),
          strain.longitudinal - motion.alongStrain(radius),
          std::abs(strain.circumferentialLongitudinal) - motion.shearStrain(radius)})
      held.add(error);
  }
}

TEST(WallFields, DoNotDependOnTheNumberOfThreads) {
  const FoundWall wall;
  std::vector<bool> cap(static_cast<std::size_t>(wall.inner.triangles.rows()));
  Progress progress;
  const WallPoints one =
      wallPoints(wall.mesh, {&wall.inner, &wall.outer, nullptr}, wall.axes, cap, progress, Threads{1});
  const WallPoints four =
      wallPoints(wall.mesh, {&wall.inner, &wall.outer, nullptr}, wall.axes, cap, progress, Threads{4});
  ASSERT_EQ(one.rows, four.rows);
  EXPECT_EQ(one.depth, four.depth);
  EXPECT_EQ(one.segments, four.segments);
}

/// As fat in a groove or the root of a vessel widens a heart's surface somewhere.
TEST(WallFields, ReachAsFarAsMostOfASegmentsWall) {
  FoundWall wall;
  const double thickness = wall.tube.outer - wall.tube.inner;
  const auto reach = [&wall] { return reachOfSegments({&wall.inner, &wall.outer, nullptr}, wall.axes, {}); };
  const auto even = reach();
  for (int segment = 1; segment <= 6; ++segment)
    EXPECT_NEAR(even[static_cast<std::size_t>(segment)], 1.1 * thickness, 0.03 * thickness) << segment;
  for (Eigen::Index row = 0; row < wall.outer.points.rows(); ++row) {
    auto place = wall.outer.points.row(row);
    if (std::abs(std::atan2(place.y(), place.x())) < 0.14)
      place.head<2>() *= 2;
  }
  const auto uneven = reach();
  for (int segment = 1; segment <= 6; ++segment)
    EXPECT_NEAR(uneven[static_cast<std::size_t>(segment)], 1.1 * thickness, 0.05 * thickness) << segment;
}

TEST(WallFields, LeaveOutTissueBeyondTheOuterSurface) {
  const FoundWall wall;
  const double middle = (wall.tube.inner + wall.tube.outer) / 2;
  const geometry::TriangleMesh thin = tests::closedTube(middle, 0, wall.tube.length, 48, 30);
  Progress progress;
  const WallPoints points = wallPoints(wall.mesh, {&wall.inner, &thin, nullptr}, wall.axes, {}, progress);
  ASSERT_GT(points.count(), 1000);
  double farthest = 0;
  for (const std::int32_t row : points.rows)
    farthest = std::max(farthest, wall.mesh.points.row(row).head<2>().norm());
  EXPECT_LT(farthest, wall.tube.inner + 1.15 * (middle - wall.tube.inner));
}

TEST(WallFields, RefuseTissueThatIsNotBetweenTheSurfaces) {
  const FoundWall wall;
  const geometry::TriangleMesh far = tests::closedTube(300, 0, 90, 12, 4);
  Progress progress;
  EXPECT_THROW(wallPoints(wall.mesh, {&wall.inner, &far, nullptr}, wall.axes, {}, progress), DataError);
}

} // namespace
} // namespace viscera::strain
