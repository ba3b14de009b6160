#include "viscera/geometry/volume.h"

#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "shapes.h"

namespace viscera::geometry {
namespace {

/// The thesis's quadrature of the divergence theorem (5.1.1, table 5.1), the reference for the closed form.
double quadratureVolume(const TriangleMesh& mesh) {
  const double corner[4][3] = {{1. / 3, 1. / 3, 1. / 3}, {0.6, 0.2, 0.2}, {0.2, 0.6, 0.2}, {0.2, 0.2, 0.6}};
  const double weight[4] = {-0.5625, 25. / 48, 25. / 48, 25. / 48};
  double sum = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const Vec3 a = mesh.points.row(mesh.triangles(t, 0)).transpose();
    const Vec3 b = mesh.points.row(mesh.triangles(t, 1)).transpose();
    const Vec3 c = mesh.points.row(mesh.triangles(t, 2)).transpose();
    const Vec3 areaNormal = 0.5 * (b - a).cross(c - a);
    for (int k = 0; k < 4; ++k)
      sum += weight[k] * (corner[k][0] * a + corner[k][1] * b + corner[k][2] * c).dot(areaNormal) / 3;
  }
  return sum;
}

TriangleMesh crumpledSphere() {
  TriangleMesh mesh = tests::sphere(5, 40, {10, -20, 5});
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-0.3, 0.3);
  for (Eigen::Index i = 0; i < mesh.points.size(); ++i)
    mesh.points.data()[i] += shift(random);
  return mesh;
}

TEST(Volume, OfPolyhedraIsExact) {
  const auto box = tests::box(2, 3, 5);
  EXPECT_NEAR(volume(box.points, box.triangles), 30, 30 * 1e-14);
  const auto tetrahedron = tests::tetrahedron(2, 3, 5);
  EXPECT_NEAR(volume(tetrahedron.points, tetrahedron.triangles), 5, 5 * 1e-14);
}

TEST(Volume, OfASphereConvergesInSecondOrder) {
  const auto errorAt = [](int levels) {
    const auto mesh = tests::sphere(levels);
    return 4 * std::numbers::pi / 3 - volume(mesh.points, mesh.triangles);
  };
  EXPECT_NEAR(errorAt(4) / errorAt(5), 4, 0.1);
}

TEST(Volume, EqualsTheThesisQuadrature) {
  const auto mesh = crumpledSphere();
  const double exact = volume(mesh.points, mesh.triangles);
  EXPECT_NEAR(quadratureVolume(mesh), exact, 1e-12 * exact);
}

TEST(Volume, IsNegativeInsideOut) {
  auto mesh = tests::box();
  mesh.triangles.col(1).swap(mesh.triangles.col(2));
  EXPECT_NEAR(volume(mesh.points, mesh.triangles), -1, 1e-14);
}

TEST(Volume, FarFromTheOriginLosesNothing) {
  auto mesh = tests::box(2, 3, 5);
  mesh.points.rowwise() += Eigen::RowVector3d(1e6, -1e6, 1e6);
  EXPECT_NEAR(volume(mesh.points, mesh.triangles), 30, 1e-8);
}

TEST(Volume, IsTheSameToTheBitForAnyNumberOfThreads) {
  const auto mesh = crumpledSphere();
  const double one = volume(mesh.points, mesh.triangles, {1});
  for (int threads : {2, 3, 8})
    EXPECT_EQ(volume(mesh.points, mesh.triangles, {threads}), one);
}

TEST(VolumeGradient, AgreesWithCentralDifferences) {
  auto mesh = crumpledSphere();
  const auto around = vertexTriangles(mesh.points.rows(), mesh.triangles);
  Points gradient;
  volumeGradient(mesh.points, mesh.triangles, around, gradient);
  const double step = 1e-3;
  for (Eigen::Index v = 0; v < mesh.points.rows(); v += 97)
    for (int k = 0; k < 3; ++k) {
      const double old = mesh.points(v, k);
      mesh.points(v, k) = old + step;
      const double high = volume(mesh.points, mesh.triangles);
      mesh.points(v, k) = old - step;
      const double low = volume(mesh.points, mesh.triangles);
      mesh.points(v, k) = old;
      EXPECT_NEAR(gradient(v, k), (high - low) / (2 * step), 1e-6 * gradient.rowwise().norm().maxCoeff());
    }
}

TEST(VolumeGradient, OfATranslationIsZeroAndOfAScalingThreeTimesTheVolume) {
  const auto mesh = crumpledSphere();
  Points gradient;
  volumeGradient(mesh.points, mesh.triangles, vertexTriangles(mesh.points.rows(), mesh.triangles), gradient);
  const double size = gradient.rowwise().norm().sum();
  EXPECT_LT(gradient.colwise().sum().norm(), 1e-13 * size);
  const double v = volume(mesh.points, mesh.triangles);
  EXPECT_NEAR(gradient.cwiseProduct(mesh.points).sum(), 3 * v, 1e-12 * v);
}

TEST(VolumeGradient, IsTheSameToTheBitForAnyNumberOfThreads) {
  const auto mesh = crumpledSphere();
  const auto around = vertexTriangles(mesh.points.rows(), mesh.triangles);
  Points one, three;
  volumeGradient(mesh.points, mesh.triangles, around, one, {1});
  volumeGradient(mesh.points, mesh.triangles, around, three, {3});
  EXPECT_EQ(std::memcmp(one.data(), three.data(), sizeof(double) * std::size_t(one.size())), 0);
}

TEST(Area, OfABoxIsExact) {
  const auto box = tests::box(2, 3, 5);
  EXPECT_NEAR(area(box.points, box.triangles), 62, 1e-12);
}

} // namespace
} // namespace viscera::geometry
