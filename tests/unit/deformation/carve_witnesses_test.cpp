#include "viscera/deformation/witness_mesh.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "shapes.h"
#include "tetrahedra.h"

namespace viscera::deformation {
namespace {

WitnessMesh box() {
  const auto solid = viscera::tests::solidBox(16, 40);
  WitnessMesh mesh;
  mesh.points = solid.points;
  mesh.tetrahedra = solid.tetrahedra;
  mesh.witnesses = solid.points.rows() / 2;
  return mesh;
}

std::shared_ptr<const geometry::TriangleMesh> ball(double radius, const Vec3& center) {
  return std::make_shared<const geometry::TriangleMesh>(viscera::tests::sphere(4, radius, center));
}

TEST(WithoutCavities, TakesAwayTheirVolumeAndLeavesAUsableMeshWithWitnessesFirst) {
  const WitnessMesh mesh = box();
  const WitnessMesh carved = withoutCavities(mesh, {ball(18, Vec3(-15, 0, 0)), ball(10, Vec3(20, 5, 0))});
  EXPECT_NO_THROW(requireUsable(carved, "carved box"));
  const double taken = 4.0 / 3 * std::numbers::pi * (std::pow(18, 3) + std::pow(10, 3));
  const double volume = tetrahedronVolumes(carved.points, carved.tetrahedra).sum();
  EXPECT_NEAR(volume, std::pow(80, 3) - taken, 0.035 * taken) << "a wall of flat triangles";
  for (Eigen::Index t = 0; t < carved.tetrahedra.rows(); ++t) {
    Vec3 middle = Vec3::Zero();
    for (int c = 0; c < 4; ++c)
      middle += 0.25 * carved.points.row(carved.tetrahedra(t, c)).transpose();
    EXPECT_GT((middle - Vec3(-15, 0, 0)).norm(), 17.5);
  }
  for (Eigen::Index point = 0; point < carved.witnesses; ++point) {
    EXPECT_GT((carved.points.row(point).transpose() - Vec3(-15, 0, 0)).norm(), 17.5) << "no blood";
    EXPECT_GT((carved.points.row(point).transpose() - Vec3(20, 5, 0)).norm(), 9.7) << "no blood";
  }
  // Witnesses are those that were witnesses, in their order.
  Eigen::Index from = 0;
  for (Eigen::Index point = 0; point < carved.witnesses; ++point) {
    while (from < mesh.witnesses && mesh.points.row(from) != carved.points.row(point))
      ++from;
    ASSERT_LT(from, mesh.witnesses);
  }
}

/// The corners of the skin that are not on the box.
std::vector<Vec3> wallOf(const WitnessMesh& carved) {
  std::vector<Vec3> wall;
  const Triangles skin = skinOf(carved.tetrahedra);
  for (Eigen::Index i = 0; i < skin.size(); ++i) {
    const Vec3 corner = carved.points.row(skin.data()[i]).transpose();
    if (corner.cwiseAbs().maxCoeff() < 40 - 1e-9)
      wall.push_back(corner);
  }
  return wall;
}

TEST(WithoutCavities, LeavesASkinThatIsTheCavitysWall) {
  const Vec3 center(-3, 2, 1);
  const WitnessMesh carved = withoutCavities(box(), {ball(21, center)});
  const std::vector<Vec3> wall = wallOf(carved);
  ASSERT_GT(wall.size(), 300u);
  for (const Vec3& corner : wall) // Edges are 5 to 9 mm long.
    EXPECT_NEAR((corner - center).norm(), 21, 0.6);
}

TEST(WithoutCavities, KeepsAWallThinnerThanTetrahedraBetweenTwoCavities) {
  // A septum of 4 mm between two balls, in tetrahedra of 5 mm.
  const WitnessMesh carved = withoutCavities(box(), {ball(16, Vec3(-18, 0, 0)), ball(16, Vec3(18, 0, 0))});
  EXPECT_NO_THROW(requireUsable(carved, "carved box"));
  const double taken = 2 * 4.0 / 3 * std::numbers::pi * std::pow(16, 3);
  EXPECT_NEAR(tetrahedronVolumes(carved.points, carved.tetrahedra).sum(), std::pow(80, 3) - taken,
              0.035 * taken);
}

TEST(WithoutCavities, IsTheSameOnAnyNumberOfThreads) {
  const std::vector<std::shared_ptr<const geometry::TriangleMesh>> cavities = {ball(18, Vec3(-15, 0, 0)),
                                                                               ball(10, Vec3(20, 5, 0))};
  const WitnessMesh one = withoutCavities(box(), cavities, {1}),
                    three = withoutCavities(box(), cavities, {3});
  EXPECT_EQ(one.points, three.points);
  EXPECT_EQ(one.tetrahedra, three.tetrahedra);
  EXPECT_EQ(one.witnesses, three.witnesses);
}

TEST(WithoutCavities, ChangesNothingWithoutCavitiesOrWhenNothingWouldBeLeft) {
  const WitnessMesh mesh = box();
  EXPECT_EQ(withoutCavities(mesh, {}).tetrahedra, mesh.tetrahedra);
  EXPECT_EQ(withoutCavities(mesh, {ball(10, Vec3(200, 0, 0))}).points, mesh.points);
  EXPECT_EQ(withoutCavities(mesh, {ball(200, Vec3::Zero())}).tetrahedra, mesh.tetrahedra);
}

} // namespace
} // namespace viscera::deformation
