#include "viscera/heart/heart_frame.h"

#include <cmath>

#include <gtest/gtest.h>

#include "viscera/core/error.h"

namespace viscera::heart {
namespace {

const HeartFrame kFrame({-8, 22, 18}, {-0.62, -0.78, 0.05}, {0.64, -0.55, -0.54});

TEST(HeartFrame, isOrthonormalAndRightHanded) {
  const Vec3 a = kFrame.toWorld(Vec3(1, 0, 0)) - kFrame.origin();
  const Vec3 b = kFrame.toWorld(Vec3(0, 1, 0)) - kFrame.origin();
  const Vec3 c = kFrame.toWorld(Vec3(0, 0, 1)) - kFrame.origin();
  EXPECT_NEAR((a.cross(b) - c).norm(), 0, 1e-14);
  EXPECT_NEAR(a.norm(), 1, 1e-14);
  EXPECT_NEAR((c - Vec3(0.64, -0.55, -0.54).normalized()).norm(), 0, 1e-14);
}

TEST(HeartFrame, comesBackFromItsCoordinates) {
  const Vec3 point(31, -12, 47);
  EXPECT_NEAR((kFrame.toWorld(kFrame.toLocal(point)) - point).norm(), 0, 1e-12);
  EXPECT_NEAR((kFrame.toWorld(kFrame.cylindrical(point)) - point).norm(), 0, 1e-12);
}

TEST(HeartFrame, measuresDistanceFromTheLongAxis) {
  const Vec3 onAxis = kFrame.origin() + 40 * kFrame.towardsApex();
  EXPECT_NEAR(kFrame.cylindrical(onAxis).rho, 0, 1e-12);
  EXPECT_NEAR(kFrame.cylindrical(onAxis).c, 40, 1e-12);
}

TEST(HeartFrame, refusesDirectionsOnOneLine) {
  EXPECT_THROW(HeartFrame(Vec3::Zero(), {0, 0, 2}, {0, 0, 1}), DataError);
  EXPECT_THROW(HeartFrame(Vec3::Zero(), {1, 0, 0}, {0, 0, 0}), DataError);
  EXPECT_THROW(HeartFrame({NAN, 0, 0}, {1, 0, 0}, {0, 0, 1}), DataError);
}

} // namespace
} // namespace viscera::heart
