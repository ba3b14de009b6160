#include "viscera/core/exact_sum.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace viscera {
namespace {

double sumOf(const std::vector<double>& values) {
  ExactSum sum;
  for (const double value : values)
    sum.add(value);
  return sum.value();
}

std::vector<double> wideNumbers(int count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-300, 300);
  std::vector<double> values;
  for (int i = 0; i < count; ++i)
    values.push_back(std::ldexp(mantissa(random), exponent(random)));
  return values;
}

TEST(ExactSum, LosesNothingThatRoundingWould) {
  EXPECT_EQ(sumOf({1e300, 1, -1e300}), 1);
  EXPECT_EQ(sumOf({1, 1e-300, -1}), 1e-300);
  EXPECT_EQ(sumOf({std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::denorm_min()}),
            2 * std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(sumOf({0.1, 0.2, -0.3}), 2.7755575615628914e-17); // by exact fractions
  EXPECT_EQ(sumOf({}), 0);
  EXPECT_EQ(sumOf({-5, 3}), -2);
  EXPECT_EQ(sumOf({std::numeric_limits<double>::max(), -std::numeric_limits<double>::max(), -1e-9}), -1e-9);
}

TEST(ExactSum, RoundsToTheNearestAndTiesToEven) {
  const double ulp = std::ldexp(1, -52);
  EXPECT_EQ(sumOf({1, ulp / 2}), 1);
  EXPECT_EQ(sumOf({1, ulp / 2, 1e-300}), 1 + ulp);
  EXPECT_EQ(sumOf({1 + ulp, ulp / 2}), 1 + 2 * ulp);
  EXPECT_EQ(sumOf({-1, -ulp / 2, -1e-300}), -1 - ulp);
}

TEST(ExactSum, IsTheSameInAnyOrderAndInAnyParts) {
  std::vector<double> values = wideNumbers(20000);
  const double expected = sumOf(values);
  std::mt19937 random(1);
  for (int round = 0; round < 3; ++round) {
    std::shuffle(values.begin(), values.end(), random);
    EXPECT_EQ(sumOf(values), expected);
    ExactSum parts[3];
    ExactSum::Limbs limbs = {};
    for (std::size_t i = 0; i < values.size(); ++i)
      parts[i % 7 % 3].add(values[i]);
    for (ExactSum& part : parts)
      for (std::size_t i = 0; i < limbs.size(); ++i)
        limbs[i] += part.limbs()[i];
    EXPECT_EQ(ExactSum::fromLimbs(limbs).value(), expected);
    parts[0].add(parts[1]);
    parts[0].add(parts[2]);
    EXPECT_EQ(parts[0].value(), expected);
  }
}

TEST(ExactSum, OfWhatIsNotFiniteIsNoNumber) {
  EXPECT_TRUE(std::isnan(sumOf({1, std::numeric_limits<double>::infinity()})));
  EXPECT_TRUE(std::isnan(sumOf({std::numeric_limits<double>::quiet_NaN(), 1})));
}

} // namespace
} // namespace viscera
