#define VISCERA_ISA tested
#include "simd/pack_math.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace viscera::coordinates::simd::tested {

TEST(PackMath, ExponentialAgreesWithTheStandardOne) {
  double worst = 0;
  for (double value = -708; value <= 708; value += 0.37) {
    const double expected = std::exp(value);
    worst = std::max(worst, std::abs(exponential(splat(value))[1] - expected) / expected);
  }
  EXPECT_LT(worst, 3 * std::numeric_limits<double>::epsilon());
}

TEST(PackMath, ExponentialStaysFiniteBeyondItsRange) {
  EXPECT_EQ(exponential(splat(1e6))[0], exponential(splat(708))[0]);
  EXPECT_TRUE(std::isfinite(exponential(splat(1e6))[0]));
  EXPECT_GT(exponential(splat(-1e6))[0], 0);
  EXPECT_EQ(exponential(splat(0))[0], 1);
}

TEST(PackMath, LogarithmAgreesWithTheStandardOne) {
  double worst = 0;
  for (double value = 1e-300; value < 1e300; value *= 1.7)
    worst =
        std::max(worst, std::abs(logarithm(splat(value))[0] - std::log(value)) / std::abs(std::log(value)));
  for (double value = 0.5; value < 2; value += 1e-3)
    worst = std::max(worst, std::abs(logarithm(splat(value))[1] - std::log(value)));
  EXPECT_LT(worst, 4 * std::numeric_limits<double>::epsilon());
  EXPECT_EQ(logarithm(splat(1))[0], 0);
}

TEST(PackMath, LanesAreIndependent) {
  Pack values = splat(1);
  values[1] = 3;
  EXPECT_EQ(exponential(values)[0], exponential(splat(1))[0]);
  EXPECT_EQ(exponential(values)[1], exponential(splat(3))[1]);
  EXPECT_EQ(bits(values > 2.0), 2u);
}

} // namespace viscera::coordinates::simd::tested
