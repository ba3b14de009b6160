#include "viscera/core/cubic_root.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace viscera {
namespace {

std::array<double, 4> withRoots(double a, double b, double c, double factor = 1) {
  return {-a * b * c * factor, (a * b + b * c + c * a) * factor, -(a + b + c) * factor, factor};
}

TEST(NearestCubicRoot, PicksTheRootNearestToZero) {
  EXPECT_NEAR(nearestCubicRoot(withRoots(3, -1, 7), -100, 100).value(), -1, 1e-14);
  EXPECT_NEAR(nearestCubicRoot(withRoots(0.5, 2, -8, -4), -100, 100).value(), 0.5, 1e-14);
}

TEST(NearestCubicRoot, IsZeroWhenNothingIsMissing) {
  EXPECT_EQ(nearestCubicRoot({0, 2, 1, 1}, -10, 10).value(), 0);
}

TEST(NearestCubicRoot, HandlesLinesAndParabolas) {
  EXPECT_NEAR(nearestCubicRoot({-6, 3, 0, 0}, -10, 10).value(), 2, 1e-14);
  EXPECT_NEAR(nearestCubicRoot({-4, 0, 1, 0}, -10, 10).value(), 2, 1e-14);
  EXPECT_FALSE(nearestCubicRoot({4, 0, 1, 0}, -10, 10).has_value());
  EXPECT_FALSE(nearestCubicRoot({1, 0, 0, 0}, -10, 10).has_value());
}

TEST(NearestCubicRoot, RespectsTheLimit) {
  EXPECT_FALSE(nearestCubicRoot(withRoots(30, 40, -50), -29, 29).has_value());
  EXPECT_TRUE(nearestCubicRoot(withRoots(30, 40, -50), -31, 31).has_value());
}

TEST(NearestCubicRoot, LimitsBothSidesAndTakesARootAtTheLimit) {
  EXPECT_NEAR(nearestCubicRoot(withRoots(-1, 2, 5), -0.5, 10).value(), 2, 1e-14);
  EXPECT_FALSE(nearestCubicRoot(withRoots(-1, 2, 5), -0.5, 1.5).has_value());
  EXPECT_EQ(nearestCubicRoot({-6, 3, 0, 0}, -1, 2).value(), 2);
}

TEST(NearestCubicRoot, MeetsItsTargetToRounding) {
  const std::array<double, 4> cubic{812.345, 431.2, 77.7, -3.3};
  for (const double target : {700.0, 800.0, 812.345, 858.5, 950.0}) {
    const auto x = nearestCubicRoot({cubic[0] - target, cubic[1], cubic[2], cubic[3]}, -0.5, 0.8);
    ASSERT_TRUE(x.has_value()) << target;
    EXPECT_NEAR(cubic[0] + *x * (cubic[1] + *x * (cubic[2] + *x * cubic[3])), target, 1e-12 * target);
  }
}

TEST(NearestCubicRoot, FindsTheNearestOfRandomRoots) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> root(-5, 5);
  for (int i = 0; i < 10'000; ++i) {
    const double a = root(random), b = root(random), c = root(random);
    const double nearest = std::min({std::abs(a), std::abs(b), std::abs(c)});
    const auto found = nearestCubicRoot(withRoots(a, b, c, std::exp(root(random))), -100, 100);
    ASSERT_TRUE(found.has_value());
    EXPECT_NEAR(std::abs(*found), nearest, 1e-6);
  }
}

} // namespace
} // namespace viscera
