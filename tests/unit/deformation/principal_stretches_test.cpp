#include "viscera/deformation/rotational_stress.h"

#include <random>
#include <set>

#include <gtest/gtest.h>

#include "viscera/deformation/witness_mesh.h"

namespace viscera::deformation {
namespace {

TEST(PrincipalStretches, RebuildTheLeftStretchOfAnyGradient) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 200; ++i) {
    const Eigen::Matrix3d m =
        Eigen::Matrix3d::Identity() + 0.4 * Eigen::Matrix3d::NullaryExpr([&] { return normal(random); });
    const auto result = principalStretches(m);
    const Eigen::Matrix3d axes = result.directions.toRotationMatrix();
    const Eigen::Matrix3d squared = axes * result.stretches.cwiseAbs2().asDiagonal() * axes.transpose();
    EXPECT_LT((squared - m * m.transpose()).cwiseAbs().maxCoeff(), 1e-12 * (m * m.transpose()).norm());
    EXPECT_GE(result.stretches[0], result.stretches[1]);
    EXPECT_GE(result.stretches[1], result.stretches[2]);
  }
}

TEST(PrincipalStretches, OfAStretchAlongOneAxisAreThatAxis) {
  const auto result = principalStretches(Vec3(1, 1.5, 0.8).asDiagonal());
  EXPECT_NEAR((result.stretches - Vec3(1.5, 1, 0.8)).norm(), 0, 1e-12);
  EXPECT_NEAR(std::abs((result.directions * Vec3::UnitX()).y()), 1, 1e-12);
}

TEST(ThinnedPoints, AreFewEnoughSpreadEvenlyAndAlwaysTheSame) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0, 50);
  Points points = Points::NullaryExpr(5000, 3, [&] { return place(random); });
  const auto chosen = thinnedPoints(points, 4000, 200);
  EXPECT_LE(chosen.size(), 200u);
  EXPECT_GE(chosen.size(), 100u);
  EXPECT_LT(chosen.back(), 4000);
  EXPECT_EQ(std::set<int>(chosen.begin(), chosen.end()).size(), chosen.size());
  EXPECT_EQ(thinnedPoints(points, 4000, 200), chosen);
  // No place of the cube is far from all of them.
  double farthest = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    double nearest = 1e9;
    for (const int j : chosen)
      nearest = std::min(nearest, (points.row(i) - points.row(j)).norm());
    farthest = std::max(farthest, nearest);
  }
  EXPECT_LT(farthest, 20);
  EXPECT_EQ(thinnedPoints(points, 10, 200).size(), 10u);
}

} // namespace
} // namespace viscera::deformation
