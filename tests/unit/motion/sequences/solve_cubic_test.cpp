#include "viscera/sequences/pose_compensation.h"

#include <gtest/gtest.h>

namespace viscera::sequences {
namespace {

TEST(SolveCubic, findsTheRootNearestToTheGuess) {
  // (x - 1)(x + 2)(x - 4) = x^3 - 3 x^2 - 6 x + 8
  const std::array<double, 4> cubic{8, -6, -3, 1};
  EXPECT_NEAR(*solveCubic(cubic, 0, 0.6, -10, 10), 1, 1e-14);
  EXPECT_NEAR(*solveCubic(cubic, 0, -1.6, -10, 10), -2, 1e-14);
  EXPECT_NEAR(*solveCubic(cubic, 0, 3.6, -10, 10), 4, 1e-14);
}

TEST(SolveCubic, meetsItsTargetToRounding) {
  const std::array<double, 4> cubic{812.345, 431.2, 77.7, -3.3};
  for (const double target : {700.0, 800.0, 812.345, 858.5, 950.0}) {
    const auto x = solveCubic(cubic, target, 0, -0.5, 0.8);
    ASSERT_TRUE(x.has_value()) << target;
    EXPECT_NEAR(cubic[0] + *x * (cubic[1] + *x * (cubic[2] + *x * cubic[3])), target, 1e-12 * target);
  }
}

TEST(SolveCubic, takesLinesAndExactGuesses) {
  EXPECT_NEAR(*solveCubic({1, 2, 0, 0}, 3, 0, -5, 5), 1, 1e-15);
  EXPECT_EQ(*solveCubic({3, 2, 0, 0}, 3, 0, -5, 5), 0);
}

TEST(SolveCubic, saysWhenThereIsNone) {
  EXPECT_FALSE(solveCubic({1, 2, 0, 0}, 30, 0, -5, 5).has_value());
  EXPECT_FALSE(solveCubic({1, 0, 1, 0}, 0, 0, -5, 5).has_value());
}

} // namespace
} // namespace viscera::sequences
