#include <cmath>

#include <gtest/gtest.h>

#include "beating_shell.h"
#include "viscera/geometry/volume.h"
#include "viscera/tracking/mask.h"
#include "viscera/tracking/mask_distance.h"

namespace viscera::tracking {
namespace {

/// Half a turn and a half around an oblique axis, mirrored along k.
Mask oblique(Mask grid) {
  const Eigen::Affine3d turn = Eigen::Translation3d(12, -7, 3) *
                               Eigen::AngleAxisd(0.6, Vec3(1, 2, -1).normalized()) *
                               Eigen::Scaling(1.0, 1.0, -1.0);
  grid.indexToLps = turn * grid.indexToLps;
  return grid;
}

geometry::TriangleMesh ball() {
  geometry::TriangleMesh mesh = tests::sphere(4, 25, Vec3(12, -7, 3));
  return mesh;
}

TEST(Voxelised, AsksTheGridOnlyForSizeAndPlace) {
  Mask grid = oblique(tests::gridAround(Vec3(3, 3, 3)));
  const Mask expected = voxelised(ball(), grid);
  grid.inside.clear();
  EXPECT_EQ(voxelised(ball(), grid).inside, expected.inside);
}

TEST(Voxelised, HoldsTheVolumeOfTheSurfaceOnAnObliqueLeftHandedGrid) {
  const Mask mask = voxelised(ball(), oblique(tests::gridAround(Vec3(1, 1.2, 0.9))));
  const geometry::TriangleMesh mesh = ball();
  EXPECT_NEAR(mask.volumeMl(), geometry::volume(mesh.points, mesh.triangles) / 1000, 0.1);
  EXPECT_DOUBLE_EQ(diceOf(mask, mask), 1);
  Mask other = mask;
  std::fill(other.inside.begin(), other.inside.end(), std::uint8_t{0});
  EXPECT_DOUBLE_EQ(diceOf(mask, other), 0);
}

TEST(BetweenSlices, BringsBackTheShapeOfThickSlices) {
  const Mask thick = voxelised(ball(), oblique(tests::gridAround(Vec3(1.5, 1.5, 8))));
  ASSERT_EQ(thickAxis(thick), 2);
  const Mask fine = betweenSlices(thick);
  EXPECT_NEAR(fine.spacing()[2], 1.5, 1e-9);
  EXPECT_EQ(thickAxis(fine), -1);
  const Mask truth = voxelised(ball(), fine);
  EXPECT_GT(diceOf(fine, truth), 0.955);
  // Steps without interpolation would do worse.
  Mask steps = truth;
  const Eigen::Affine3d toThick = thick.indexToLps.inverse() * fine.indexToLps;
  for (int k = 0; k < fine.size[2]; ++k)
    for (int j = 0; j < fine.size[1]; ++j)
      for (int i = 0; i < fine.size[0]; ++i) {
        const Vec3 at = toThick * Vec3(i, j, k);
        const int slice = static_cast<int>(std::lround(at[2]));
        steps.inside[steps.indexOf(i, j, k)] =
            slice >= 0 && slice < thick.size[2] ? thick.inside[thick.indexOf(i, j, slice)] : 0;
      }
  EXPECT_GT(diceOf(fine, truth), diceOf(steps, truth) + 0.005);
}

TEST(BetweenSlices, LeavesEvenVoxelsAlone) {
  const Mask even = voxelised(ball(), oblique(tests::gridAround(Vec3(2, 2, 3))));
  EXPECT_EQ(thickAxis(even), -1);
  EXPECT_EQ(betweenSlices(even).inside, even.inside);
}

TEST(MaskDistance, IsThatToTheSurfaceInsideOutsideAndFarAway) {
  const MaskDistance distance(voxelised(ball(), oblique(tests::gridAround(Vec3(1, 1, 1)))));
  for (const double radius : {3.0, 15.0, 24.0, 25.0, 26.0, 33.0, 60.0, 90.0})
    for (const Vec3& way : {Vec3(1, 0.2, 0.1), Vec3(-0.3, 1, 0.5), Vec3(0.2, -0.4, -1)}) {
      const Vec3 outward = way.normalized();
      Vec3 direction;
      const double found = distance.at(Vec3(12, -7, 3) + radius * outward, direction);
      EXPECT_NEAR(found, radius - 25, radius > 40 ? 3 : radius < 10 ? 1 : 0.6) << radius;
      if (radius > 10) {
        EXPECT_GT(direction.dot(outward), 0.9) << radius;
      }
    }
}

TEST(MaskDistance, DoesNotDependOnTheNumberOfThreads) {
  const Mask mask = voxelised(ball(), oblique(tests::gridAround(Vec3(2, 2, 5))));
  const MaskDistance one(mask, 12, Threads{1}), three(mask, 12, Threads{3});
  Vec3 a, b;
  for (int i = 0; i < 200; ++i) {
    const Vec3 at = 45 * Vec3::Random();
    EXPECT_EQ(one.at(at, a), three.at(at, b));
    EXPECT_EQ(a, b);
  }
}

TEST(MaskDistance, TakesTheEdgeOfTheImageAsTheEndOfWhatItCuts) {
  Mask mask = tests::gridAround(Vec3(1, 1, 1), 10);
  std::fill(mask.inside.begin(), mask.inside.end(), std::uint8_t{1});
  const MaskDistance distance(mask);
  Vec3 direction;
  EXPECT_NEAR(distance.at(Vec3(13, 0, 0), direction), 3, 0.1);
  EXPECT_NEAR(distance.at(Vec3(6, 0, 0), direction), -4, 0.1);
}

} // namespace
} // namespace viscera::tracking
