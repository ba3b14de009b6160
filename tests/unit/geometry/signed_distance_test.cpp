#include "viscera/geometry/signed_distance.h"

#include <cmath>
#include <memory>
#include <random>

#include <gtest/gtest.h>

#include "clouds.h"
#include "shapes.h"
#include "viscera/core/error.h"

namespace viscera::geometry {
namespace {

SignedDistance distanceTo(TriangleMesh mesh) {
  return SignedDistance(std::make_shared<const TriangleMesh>(std::move(mesh)));
}

TEST(SignedDistance, isThatOfABoxAlsoBesideItsEdgesAndCorners) {
  const SignedDistance distance = distanceTo(tests::box(2, 3, 4));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(-2, 6);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = tests::drawPlace(anywhere, random);
    const Vec3 beyond = (-p).cwiseMax(p - Vec3(2, 3, 4));
    const double wanted = beyond.cwiseMax(0).norm() + std::min(0.0, beyond.maxCoeff());
    EXPECT_NEAR(distance(p), wanted, 1e-12) << p.transpose();
  }
}

TEST(SignedDistance, nearestPointLiesOnTheSurfaceAtThatDistance) {
  const SignedDistance distance = distanceTo(tests::sphere(4, 30, {5, 6, 7}));
  for (const Vec3& p : {Vec3(5, 6, 40), Vec3(0, 0, 0), Vec3(100, -50, 3)}) {
    EXPECT_NEAR((distance.nearest(p) - p).norm(), std::abs(distance(p)), 1e-12);
    EXPECT_NEAR(distance(p), (p - Vec3(5, 6, 7)).norm() - 30, 0.3);
  }
}

TEST(SignedDistance, refusesASurfaceWithoutTriangles) {
  EXPECT_THROW(distanceTo({}), DataError);
}

} // namespace
} // namespace viscera::geometry
