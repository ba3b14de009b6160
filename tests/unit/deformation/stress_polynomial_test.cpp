#include "viscera/deformation/stress_polynomial.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace viscera::deformation {

TEST(StressPolynomial, TheMiddleSingularValuePlaysNoPart) {
  for (const double s2 : {0.4, 0.7, 1.0, 1.9}) {
    EXPECT_NEAR(stressDegrees(2, s2, 0.4), 180 / std::numbers::pi * std::asin(1.6 / 2.4), 1e-12);
    EXPECT_NEAR(searchedStressDegrees(2, s2, 0.4), stressDegrees(2, s2, 0.4), 0.01);
  }
}

TEST(StressPolynomial, OfDegreeSixIsWithin044DegreesDownToATenthOfTheLargestStretch) {
  // Figure 5.5's claim. Towards s3 = 0 all angles meet in one point and no polynomial follows.
  const double half = StressPolynomial(0.5).largestError(), tenth = StressPolynomial(0.1).largestError();
  RecordProperty("largest_error_deg_from_0.5", std::to_string(half));
  RecordProperty("largest_error_deg_from_0.1", std::to_string(tenth));
  RecordProperty("largest_error_deg_from_0.05", std::to_string(StressPolynomial(0.05).largestError()));
  EXPECT_LT(half, tenth);
  EXPECT_LT(tenth, 0.44);
  EXPECT_GT(StressPolynomial(0.001).largestError(), 0.44);
}

TEST(StressPolynomial, IsAsFarOffAsItSays) {
  const StressPolynomial fit(0.1);
  double largest = 0;
  for (double s3 = 0.1; s3 <= 1; s3 += 0.05)
    for (double s1 = s3; s1 <= 1; s1 += 0.05)
      largest = std::max(largest, std::abs(fit.degrees(s1, s3) - stressDegrees(s1, s1, s3)));
  EXPECT_GT(largest, 0.3 * fit.largestError());
  EXPECT_LT(largest, 1.1 * fit.largestError());
}

} // namespace viscera::deformation
