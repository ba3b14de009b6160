#include "viscera/geometry/sides_of_plane.h"

#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/geometry/signed_distance.h"
#include "viscera/geometry/volume.h"

namespace viscera::geometry {
namespace {

SidesOfPlane sidesOf(const TriangleMesh& mesh, const Plane& plane) {
  return sidesOfPlane({&mesh.points, &mesh.triangles}, plane);
}

TEST(SidesOfPlane, OfABoxAreTheBoxesOnBothSides) {
  const TriangleMesh mesh = tests::box(2, 3, 5);
  const double low = mesh.points.col(2).minCoeff();
  const SidesOfPlane sides = sidesOf(mesh, {Vec3(40, -7, low + 1.7), Vec3::UnitZ()});
  EXPECT_NEAR(sides.backMm3, 2 * 3 * 1.7, 1e-12);
  EXPECT_NEAR(sides.frontMm3, 2 * 3 * 3.3, 1e-12);
  EXPECT_NEAR(sides.faceMm2, 6, 1e-12);
  const SidesOfPlane turned = sidesOf(mesh, {Vec3(0, 0, low + 1.7), -Vec3::UnitZ()});
  EXPECT_NEAR(turned.frontMm3, sides.backMm3, 1e-12);
}

TEST(SidesOfPlane, OfASphereAreItsCaps) {
  const Vec3 middle(4, -3, 8), normal = Vec3(1, 2, 2) / 3;
  const double radius = 10, height = 4; // The cap's own height.
  const TriangleMesh mesh = tests::sphere(6, radius, middle);
  const SidesOfPlane sides = sidesOf(mesh, {middle + (radius - height) * normal, normal});
  const double cap = std::numbers::pi * height * height * (3 * radius - height) / 3;
  EXPECT_NEAR(sides.frontMm3, cap, 2e-3 * cap);
  EXPECT_NEAR(sides.faceMm2, std::numbers::pi * (2 * radius * height - height * height), 0.3);
}

TEST(SidesOfPlane, AddUpToTheVolumeInAnyPlaneEvenThroughVertices) {
  const TriangleMesh mesh = tests::sphere(4, 10, Vec3(4, -3, 8));
  const double whole = volume(mesh.points, mesh.triangles);
  std::mt19937 random(3);
  std::normal_distribution<double> number;
  for (int i = 0; i < 40; ++i) {
    const Vec3 normal = Vec3(number(random), number(random), number(random)).normalized();
    const SidesOfPlane sides = sidesOf(mesh, {mesh.points.row(17 * i).transpose(), normal});
    EXPECT_NEAR(sides.frontMm3 + sides.backMm3, whole, 1e-12 * whole) << i;
    EXPECT_GE(sides.frontMm3, -1e-12 * whole);
    EXPECT_GE(sides.backMm3, -1e-12 * whole);
  }
}

// Counting points is slow and rough, but has nothing in common with clipping.
TEST(SidesOfPlane, AgreeWithCountedPointsOfAHollowSurface) {
  TriangleMesh mesh = tests::sphere(4, 10);
  const TriangleMesh hole = tests::sphere(4, 6, Vec3(2, 0, 1));
  const Eigen::Index n = mesh.points.rows(), m = mesh.triangles.rows();
  mesh.points.conservativeResize(n + hole.points.rows(), 3);
  mesh.points.bottomRows(hole.points.rows()) = hole.points;
  mesh.triangles.conservativeResize(m + hole.triangles.rows(), 3);
  mesh.triangles.bottomRows(hole.triangles.rows()) =
      (hole.triangles.array() + static_cast<int>(n)).rowwise().reverse();
  const Plane plane{Vec3(1, 2, -1), Vec3(2, -1, 2) / 3};
  const SignedDistance inside(std::make_shared<const TriangleMesh>(mesh));
  const double step = 0.5;
  double front = 0, back = 0;
  for (double x = -10; x < 10; x += step)
    for (double y = -10; y < 10; y += step)
      for (double z = -10; z < 10; z += step) {
        const Vec3 place = Vec3(x, y, z) + 0.5 * step * Vec3::Ones();
        if (inside(place) < 0)
          (plane.height(place) > 0 ? front : back) += step * step * step;
      }
  const SidesOfPlane sides = sidesOf(mesh, plane);
  EXPECT_NEAR(sides.frontMm3, front, 0.01 * front);
  EXPECT_NEAR(sides.backMm3, back, 0.01 * back);
}

TEST(SidesOfPlane, BesideASurfaceAreAllAndNothing) {
  const TriangleMesh mesh = tests::box(2, 3, 5);
  const SidesOfPlane sides = sidesOf(mesh, {Vec3(100, 0, 0), Vec3::UnitX()});
  EXPECT_EQ(sides.frontMm3, 0);
  EXPECT_NEAR(sides.backMm3, 30, 1e-9);
  EXPECT_EQ(sides.faceMm2, 0);
  EXPECT_FALSE(sides.cuts());
}

} // namespace
} // namespace viscera::geometry
