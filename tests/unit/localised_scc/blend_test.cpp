#include "blend.h"

#include <gtest/gtest.h>

namespace viscera::localised_scc {

TEST(Blend, IsOneInTheZoneAndZeroBeyondTheOffset) {
  EXPECT_EQ(blendAt(0, Vec3::UnitX(), 5).value, 1);
  EXPECT_EQ(blendAt(5, Vec3::UnitX(), 5).value, 0);
  EXPECT_EQ(blendAt(9, Vec3::UnitX(), 5).value, 0);
  EXPECT_DOUBLE_EQ(blendAt(2.5, Vec3::UnitX(), 5).value, 0.5);
}

TEST(Blend, GradientAgreesWithDifferencesAndVanishesAtBothEnds) {
  const double step = 1e-6;
  for (double d = 0.1; d < 5; d += 0.37) {
    const double slope =
        (blendAt(d + step, Vec3::UnitY(), 5).value - blendAt(d - step, Vec3::UnitY(), 5).value) / (2 * step);
    EXPECT_NEAR(blendAt(d, Vec3::UnitY(), 5).gradient[1], slope, 1e-8);
  }
  EXPECT_NEAR(blendAt(1e-9, Vec3::UnitY(), 5).gradient.norm(), 0, 1e-8);
  EXPECT_NEAR(blendAt(5 - 1e-9, Vec3::UnitY(), 5).gradient.norm(), 0, 1e-8);
}

TEST(Partition, AddsUpToOneAndGivesAllToAZoneThatHoldsThePoint) {
  const auto parts = partition({{0.4, Vec3(1, 0, 0)}, {0.7, Vec3(0, 2, 0)}});
  ASSERT_EQ(parts.size(), 3u);
  double sum = 0;
  Vec3 gradients = Vec3::Zero();
  for (const auto& part : parts) {
    sum += part.value;
    gradients += part.gradient;
  }
  EXPECT_NEAR(sum, 1, 1e-15);
  EXPECT_NEAR(gradients.norm(), 0, 1e-14);
  EXPECT_EQ(partition({{1, Vec3::Zero()}, {0.7, Vec3::Zero()}})[0].value, 1);
}

} // namespace viscera::localised_scc
