#include "viscera/sequences/curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "viscera/core/error.h"

namespace viscera::sequences {
namespace {

const std::vector<Key> kHills{{0, 1}, {0.3, 4}, {0.35, 3.5}, {0.9, -2}, {1.0, -2}, {1.6, 0.5}};

TEST(Curve, passesThroughItsKeys) {
  const Curve curve = Curve::through(kHills);
  for (const Key& key : kHills)
    EXPECT_NEAR(curve.at(key.at), key.value, 1e-14);
}

TEST(Curve, isLevelAtEveryExtremumAndAtItsEnds) {
  const Curve curve = Curve::through(kHills);
  for (const double at : {0.0, 0.3, 0.9, 1.0, 1.6})
    EXPECT_EQ(curve.slopeAt(at), 0) << at;
  EXPECT_LT(curve.slopeAt(0.35), 0);
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
  EXPECT_EQ(curve.slopeAt(8), 0);
}

TEST(Curve, hasTheSlopeThatDifferencesShow) {
  const Curve curve = Curve::periodic({{0.1, 2}, {0.4, 5}, {0.6, 6}, {0.8, 1}}, 1);
  constexpr double kStep = 1e-6;
  for (int k = 0; k < 200; ++k) {
    const double x = -0.3 + 0.01 * k + 0.0037;
    EXPECT_NEAR(curve.slopeAt(x), (curve.at(x + kStep) - curve.at(x - kStep)) / (2 * kStep), 1e-3) << x;
  }
}

TEST(Curve, repeatsItselfWithoutAKinkWhereThePeriodEnds) {
  // Ascending through the end of the period: the slope there is not level.
  const Curve curve = Curve::periodic({{0, 3}, {0.2, 5}, {0.6, 1}, {0.9, 2.5}}, 1);
  EXPECT_GT(curve.slopeAt(0), 0.5);
  EXPECT_NEAR(curve.slopeAt(1 - 1e-9), curve.slopeAt(1 + 1e-9), 1e-6);
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
