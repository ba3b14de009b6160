#include "cubic_root.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace viscera::deformation {
namespace {

std::array<double, 4> withRoots(double a, double b, double c, double factor = 1) {
  return {-a * b * c * factor, (a * b + b * c + c * a) * factor, -(a + b + c) * factor, factor};
}

TEST(NearestCubicRoot, PicksTheRootNearestToZero) {
  EXPECT_NEAR(nearestCubicRoot(withRoots(3, -1, 7), 100).value(), -1, 1e-14);
  EXPECT_NEAR(nearestCubicRoot(withRoots(0.5, 2, -8, -4), 100).value(), 0.5, 1e-14);
}

TEST(NearestCubicRoot, IsZeroWhenNothingIsMissing) {
  EXPECT_EQ(nearestCubicRoot({0, 2, 1, 1}, 10).value(), 0);
}

TEST(NearestCubicRoot, HandlesLinesAndParabolas) {
  EXPECT_NEAR(nearestCubicRoot({-6, 3, 0, 0}, 10).value(), 2, 1e-14);
  EXPECT_NEAR(nearestCubicRoot({-4, 0, 1, 0}, 10).value(), 2, 1e-14);
  EXPECT_FALSE(nearestCubicRoot({4, 0, 1, 0}, 10).has_value());
  EXPECT_FALSE(nearestCubicRoot({1, 0, 0, 0}, 10).has_value());
}

TEST(NearestCubicRoot, RespectsTheLimit) {
  EXPECT_FALSE(nearestCubicRoot(withRoots(30, 40, -50), 29).has_value());
  EXPECT_TRUE(nearestCubicRoot(withRoots(30, 40, -50), 31).has_value());
}

TEST(NearestCubicRoot, FindsTheNearestOfRandomRoots) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> root(-5, 5);
  for (int i = 0; i < 10'000; ++i) {
    const double a = root(random), b = root(random), c = root(random);
    const double nearest = std::min({std::abs(a), std::abs(b), std::abs(c)});
    const auto found = nearestCubicRoot(withRoots(a, b, c, std::exp(root(random))), 100);
    ASSERT_TRUE(found.has_value());
    EXPECT_NEAR(std::abs(*found), nearest, 1e-6);
  }
}

} // namespace
} // namespace viscera::deformation
