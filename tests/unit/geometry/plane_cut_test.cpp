#include "viscera/geometry/plane_cut.h"

#include <numbers>

#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/core/error.h"

namespace viscera::geometry {
namespace {

PlaneCut cutOf(const TriangleMesh& mesh, const Plane& plane) {
  return cutSurface({&mesh.points, &mesh.triangles}, plane);
}

/// Twice the area that the lines go around, positive when they have it on their left seen against `normal`.
double areaOf(const PlaneCut& cut, const Plane& plane) {
  double doubled = 0;
  for (std::size_t line = 0; line < cut.lines(); ++line) {
    const Eigen::Index begin = cut.first[line], end = cut.first[line + 1];
    for (Eigen::Index i = begin; i < end; ++i) {
      const Vec3 a = cut.points.row(i).transpose() - plane.origin;
      const Vec3 b = cut.points.row(i + 1 < end ? i + 1 : begin).transpose() - plane.origin;
      doubled += plane.normal.dot(a.cross(b));
    }
  }
  return doubled / 2;
}

TEST(PlaneCut, OfABoxIsItsOutlineWithTheInsideOnTheLeft) {
  const TriangleMesh mesh = tests::box(2, 3, 5);
  const Plane plane{Vec3(0, 0, 1.7), Vec3::UnitZ()};
  const PlaneCut cut = cutOf(mesh, plane);
  ASSERT_EQ(cut.lines(), 1u);
  EXPECT_TRUE(cut.closed[0]);
  EXPECT_NEAR(cut.lengthMm, 10, 1e-12);
  EXPECT_NEAR(areaOf(cut, plane), 6, 1e-12);
  for (Eigen::Index i = 0; i < cut.points.rows(); ++i)
    EXPECT_NEAR(plane.height(cut.points.row(i).transpose()), 0, 1e-12);
  const Plane other{plane.origin, -plane.normal};
  EXPECT_NEAR(areaOf(cutOf(mesh, other), other), 6, 1e-12);
}

TEST(PlaneCut, OfASphereApproachesACircleInAnyPlane) {
  const TriangleMesh mesh = tests::sphere(5, 10, Vec3(4, -3, 8));
  const Plane plane{Vec3(4, -3, 8) + 6 * Vec3(1, 2, 2) / 3, Vec3(1, 2, 2) / 3};
  const PlaneCut cut = cutOf(mesh, plane);
  ASSERT_EQ(cut.lines(), 1u);
  EXPECT_TRUE(cut.closed[0]);
  EXPECT_NEAR(cut.lengthMm, 2 * std::numbers::pi * 8, 0.05);
  EXPECT_NEAR(areaOf(cut, plane), std::numbers::pi * 64, 0.3);
}

TEST(PlaneCut, HasARingForEachPartThatThePlaneMeets) {
  TriangleMesh two = tests::sphere(3, 1, Vec3(-3, 0, 0));
  const TriangleMesh right = tests::sphere(3, 1, Vec3(3, 0, 0));
  const Eigen::Index n = two.points.rows(), m = two.triangles.rows();
  two.points.conservativeResize(2 * n, 3);
  two.points.bottomRows(n) = right.points;
  two.triangles.conservativeResize(2 * m, 3);
  two.triangles.bottomRows(m) = right.triangles.array() + static_cast<std::int32_t>(n);
  EXPECT_EQ(cutOf(two, {Vec3(0, 0, 0.1), Vec3::UnitZ()}).lines(), 2u);
  EXPECT_EQ(cutOf(two, {Vec3(3.1, 0, 0), Vec3::UnitX()}).lines(), 1u);
  EXPECT_EQ(cutOf(two, {Vec3::Zero(), Vec3::UnitX()}).lines(), 0u);
}

TEST(PlaneCut, OfAnOpenSurfaceIsAnOpenLine) {
  TriangleMesh mesh = tests::box();
  mesh.triangles = Triangles(mesh.triangles.topRows(10)); // Without the side at x = 1.
  const PlaneCut cut = cutOf(mesh, {Vec3(0, 0, 0.3), Vec3::UnitZ()});
  ASSERT_EQ(cut.lines(), 1u);
  EXPECT_FALSE(cut.closed[0]);
  EXPECT_NEAR(cut.lengthMm, 3, 1e-12);
}

TEST(PlaneCut, GoesThroughVerticesWithoutATear) {
  // The equator of the octahedron's sphere has vertices exactly in the plane.
  const PlaneCut cut = cutOf(tests::sphere(3), {Vec3::Zero(), Vec3::UnitZ()});
  ASSERT_EQ(cut.lines(), 1u);
  EXPECT_TRUE(cut.closed[0]);
  EXPECT_NEAR(cut.lengthMm, 2 * std::numbers::pi, 0.02);
  // And the top of a box lies in the plane as a whole: it is above, so its rim is cut once.
  const PlaneCut top = cutOf(tests::box(), {Vec3(0, 0, 1), Vec3::UnitZ()});
  ASSERT_EQ(top.lines(), 1u);
  EXPECT_NEAR(top.lengthMm, 4, 1e-12);
}

TEST(PlaneCut, IsTheSameWithOneThreadAndWithFourAndForPlanesTogether) {
  const TriangleMesh big = tests::sphere(6, 20), small = tests::sphere(2, 5);
  const std::vector<SurfaceView> surfaces = {{&big.points, &big.triangles},
                                             {&small.points, &small.triangles}};
  const std::vector<Plane> planes = {
      {Vec3(0, 0, 1), Vec3::UnitZ()}, {Vec3(0, 2, 0), Vec3::UnitY()}, {Vec3(9, 0, 0), Vec3(0.6, 0, 0.8)}};
  const auto one = cutSurfaces(surfaces, planes, {1}), four = cutSurfaces(surfaces, planes, {4});
  for (std::size_t s = 0; s < surfaces.size(); ++s)
    for (std::size_t k = 0; k < planes.size(); ++k) {
      const PlaneCut alone = cutSurface(surfaces[s], planes[k], {2});
      EXPECT_EQ(one[s][k].points, four[s][k].points);
      EXPECT_EQ(one[s][k].points, alone.points);
      EXPECT_EQ(one[s][k].first, alone.first);
    }
  EXPECT_EQ(one[1][2].lines(), 0u);
}

TEST(PlaneCut, KnowsWhatIsInside) {
  const TriangleMesh mesh = tests::sphere(4, 10);
  const Plane plane{Vec3(0, 0, 6), Vec3::UnitZ()};
  const PlaneCut cut = cutOf(mesh, plane);
  EXPECT_TRUE(isInside(cut, plane, Vec3(0, 0, 6)));
  EXPECT_TRUE(isInside(cut, plane, Vec3(5, -5.5, 6)));
  EXPECT_FALSE(isInside(cut, plane, Vec3(8.2, 0, 6)));
  EXPECT_FALSE(isInside(cut, plane, Vec3(-9, 9, 6)));
}

TEST(PlaneCut, RefusesMorePlanesThanItHasBits) {
  EXPECT_THROW(cutSurfaces({}, std::vector<Plane>(9)), UsageError);
}

} // namespace
} // namespace viscera::geometry
