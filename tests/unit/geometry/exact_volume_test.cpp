#include "viscera/geometry/exact_volume.h"

#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/geometry/volume.h"

namespace viscera::geometry {
namespace {

Vec3 corner(const TriangleMesh& mesh, Eigen::Index triangle, int i) {
  return mesh.points.row(mesh.triangles(triangle, i)).transpose();
}

TEST(ExactVolume, AgreesWithTheVolumeAndHasTheSameBitsInAnyParts) {
  const TriangleMesh ball = tests::sphere(4, 40, {10, -20, 5});
  const Vec3 origin(3, 1, -50);
  ExactVolume whole(origin), odd(origin), even(origin);
  for (Eigen::Index t = 0; t < ball.triangles.rows(); ++t) {
    whole.addTriangle(corner(ball, t, 0), corner(ball, t, 1), corner(ball, t, 2));
    const Eigen::Index back = ball.triangles.rows() - 1 - t;
    (t % 2 == 0 ? even : odd)
        .addTriangle(corner(ball, back, 0), corner(ball, back, 1), corner(ball, back, 2));
  }
  const double expected = volume(ball.points, ball.triangles);
  EXPECT_NEAR(whole.mm3(), expected, 1e-13 * expected);
  odd.sixfold().add(even.sixfold());
  EXPECT_EQ(odd.mm3(), whole.mm3());
}

TEST(ExactVolume, OfATetrahedronDoesNotDependOnTheOrigin) {
  ExactVolume near(Vec3::Zero()), far({1e6, 1e6, 1e6});
  for (ExactVolume* each : {&near, &far})
    each->addTetrahedron({1, 1, 1}, {3, 1, 1}, {1, 4, 1}, {1, 1, 6});
  EXPECT_EQ(near.mm3(), 5);
  EXPECT_EQ(far.mm3(), 5);
}

TEST(ExactVolume, AlongAMotionIsACubic) {
  const TriangleMesh ball = tests::sphere(2, 30);
  Points motion = ball.points;
  motion.col(0) *= 0.1;
  motion.col(1).array() += 3;
  motion.col(2) = motion.col(2).cwiseProduct(motion.col(2)) * 0.01;
  ExactVolumeAlong surface({5, 5, 5}), solid({5, 5, 5});
  for (Eigen::Index t = 0; t < ball.triangles.rows(); ++t) {
    Eigen::Matrix3d at, by;
    Eigen::Matrix<double, 3, 4> atCone = Eigen::Matrix<double, 3, 4>::Zero(), byCone = atCone;
    for (int i = 0; i < 3; ++i) {
      at.col(i) = corner(ball, t, i);
      by.col(i) = motion.row(ball.triangles(t, i)).transpose();
    }
    atCone.rightCols<3>() = at;
    byCone.rightCols<3>() = by;
    surface.addTriangle(at, by);
    solid.addTetrahedron(atCone, byCone);
  }
  for (const ExactVolumeAlong& sums : {surface, solid}) {
    const auto c = sums.mm3();
    for (const double s : {-1.5, 0.0, 0.7, 2.0}) {
      const double expected = volume(ball.points + s * motion, ball.triangles);
      EXPECT_NEAR(c[0] + s * (c[1] + s * (c[2] + s * c[3])), expected, 1e-10 * std::abs(expected));
    }
  }
}

} // namespace
} // namespace viscera::geometry
