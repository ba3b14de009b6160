#include "viscera/scene/cut_caps.h"

#include <cmath>

#include <gtest/gtest.h>

#include "shapes.h"

namespace viscera::scene {
namespace {

const geometry::Plane kPlane{Vec3(0, 2, 0), Vec3::UnitY()};

geometry::PlaneCut cutOf(const geometry::TriangleMesh& mesh) {
  return geometry::cutSurface({&mesh.points, &mesh.triangles}, kPlane);
}

double disc(double radius) {
  return M_PI * (radius * radius - 4);
}

TEST(CutCaps, FillTheWallBetweenABallAndTheHollowsInIt) {
  CutCaps caps;
  CutCaps::Face wall{
      cutOf(tests::sphere(5, 50)),
      {cutOf(tests::sphere(4, 12, Vec3(-20, 0, 0))), cutOf(tests::sphere(4, 15, Vec3(22, 0, 0)))},
      Vec3::Ones()};
  caps.setFaces({wall}, -Vec3::UnitY());
  EXPECT_NEAR(caps.areaMm2(), disc(50) - disc(12) - disc(15), 0.01 * disc(50));
  wall.cavities.clear();
  caps.setFaces({wall}, -Vec3::UnitY());
  EXPECT_NEAR(caps.areaMm2(), disc(50), 0.005 * disc(50));
}

TEST(CutCaps, DrawNothingWhereThePlaneMeetsNothing) {
  CutCaps caps;
  caps.setFaces({{cutOf(tests::sphere(3, 5, Vec3(0, 40, 0))), {}, Vec3::Ones()}}, -Vec3::UnitY());
  EXPECT_EQ(caps.areaMm2(), 0);
}

TEST(CutCaps, SeveralOrgansHaveAFaceEach) {
  CutCaps caps;
  caps.setFaces({{cutOf(tests::sphere(4, 20, Vec3(-30, 0, 0))), {}, Vec3::Ones()},
                 {cutOf(tests::sphere(4, 10, Vec3(30, 0, 0))), {}, Vec3::Zero()}},
                -Vec3::UnitY());
  EXPECT_NEAR(caps.areaMm2(), disc(20) + disc(10), 0.01 * disc(20));
}

} // namespace
} // namespace viscera::scene
