#include "viscera/sequences/curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "viscera/core/error.h"

namespace viscera::sequences {
namespace {

const std::vector<Key> kHills{{0, 1}, {0.3, 4}, {0.35, 3.5}, {0.9, -2}, {1.0, -2}, {1.6, 0.5}};

/// By a central difference.
double slopeOf(const Curve& curve, double x) {
  constexpr double kStep = 1e-6;
  return (curve.at(x + kStep) - curve.at(x - kStep)) / (2 * kStep);
}

TEST(Curve, passesThroughItsKeys) {
  const Curve curve = Curve::through(kHills);
  for (const Key& key : kHills)
    EXPECT_NEAR(curve.at(key.at), key.value, 1e-14);
}

TEST(Curve, isLevelAtEveryExtremumAndAtItsEnds) {
  const Curve curve = Curve::through(kHills);
  for (const double at : {0.0, 0.3, 0.9, 1.0, 1.6})
    EXPECT_NEAR(slopeOf(curve, at), 0, 5e-3) << at;
  EXPECT_LT(slopeOf(curve, 0.35), -1);
}

TEST(Curve, staysBetweenNeighbouringKeys) {
  const Curve curve = Curve::through(kHills);
  for (std::size_t i = 0; i + 1 < kHills.size(); ++i) {
    const auto [low, high] = std::minmax(kHills[i].value, kHills[i + 1].value);
    for (int k = 0; k <= 100; ++k) {
      const double value = curve.at(kHills[i].at + k / 100.0 * (kHills[i + 1].at - kHills[i].at));
      EXPECT_GE(value, low - 1e-14);
      EXPECT_LE(value, high + 1e-14);
    }
  }
}

TEST(Curve, keepsItsEndValuesOutside) {
  const Curve curve = Curve::through(kHills);
  EXPECT_EQ(curve.at(-3), 1);
  EXPECT_EQ(curve.at(8), 0.5);
}

TEST(Curve, repeatsItselfWithoutAKinkWhereThePeriodEnds) {
  // Ascending through the end of the period: the slope there is not level.
  const Curve curve = Curve::periodic({{0, 3}, {0.2, 5}, {0.6, 1}, {0.9, 2.5}}, 1);
  EXPECT_GT(slopeOf(curve, 0), 0.5);
  EXPECT_NEAR(slopeOf(curve, 1 - 2e-6), slopeOf(curve, 1 + 2e-6), 5e-3);
  for (double x = 0; x < 1; x += 0.07) {
    EXPECT_NEAR(curve.at(x), curve.at(x + 5), 1e-12);
    EXPECT_NEAR(curve.at(x), curve.at(x - 3), 1e-12);
  }
}

TEST(Curve, ofAnUnevenClockAscendsStrictlyAndGainsItsRiseEachPeriod) {
  const Curve clock = Curve::periodic({{0, 0}, {0.1, 0.3}, {0.5, 0.4}, {0.9, 0.95}}, 1, 1);
  double before = clock.at(-1);
  for (int k = 1; k <= 3000; ++k) {
    const double now = clock.at(-1 + k * 1e-3);
    EXPECT_GT(now, before);
    before = now;
  }
  EXPECT_NEAR(clock.at(2.5), clock.at(0.5) + 2, 1e-12);
}

TEST(Curve, oneKeyOfAPeriodIsAConstant) {
  const Curve curve = Curve::periodic({{0.4, 7}}, 1);
  for (const double x : {-2.0, 0.0, 0.4, 0.9, 11.3})
    EXPECT_NEAR(curve.at(x), 7, 1e-14);
}

TEST(Curve, givesItsKeysBackToTheLastBit) {
  const std::vector<Key> keys = {{0.1, 3.3}, {0.4, 1 / 3.0}, {0.7, 2}};
  for (const Curve& curve : {Curve::through(keys), Curve::periodic(keys, 1, 0.5)}) {
    const std::vector<Key> back = curve.keys();
    ASSERT_EQ(back.size(), keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
      EXPECT_EQ(back[i].at, keys[i].at);
      EXPECT_EQ(back[i].value, keys[i].value);
    }
  }
}

TEST(Curve, refusesKeysThatAreNoCurve) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Curve::through({{0, 1}}), DataError);
  EXPECT_THROW(Curve::through({{0, 1}, {0, 2}}), DataError);
  EXPECT_THROW(Curve::through({{1, 1}, {0, 2}}), DataError);
  EXPECT_THROW(Curve::through({{0, nan}, {1, 2}}), DataError);
  EXPECT_THROW(Curve::periodic({}, 1), DataError);
  EXPECT_THROW(Curve::periodic({{0, 1}, {1, 1}}, 1), DataError);
}

} // namespace
} // namespace viscera::sequences
