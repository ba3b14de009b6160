#include "viscera/elasticity/stated_material.h"

#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <gtest/gtest.h>

#include "viscera/core/error.h"
#include "viscera/elasticity/tissues.h"

namespace viscera::elasticity {
namespace {

/// Lame's constants of Young's modulus 2.98 kPa at Poisson's ratio 0.49: 1 and 49 kPa.
const StatedMaterial kUnitShear = ownMaterial(2.98, 0.49);
constexpr double kUnitLambda = 49;

LocalStretch stretchOf(const Eigen::Matrix3d& f) {
  const Eigen::Vector3d s = f.jacobiSvd().singularValues();
  return {s[0], s[2], f.determinant()};
}

TEST(StatedMaterial, UniaxialStretchIsAsComputedByHand) {
  // Principal stresses mu / J (s^2 - 1) beside the pressure: 0.21 / 1.1, 0, 0.
  EXPECT_NEAR(vonMisesKpa(kUnitShear, {1.1, 1, 1.1}), 0.21 / 1.1, 1e-12);
  EXPECT_NEAR(energyKpa(kUnitShear, {1.1, 1, 1.1}), 0.5 * 0.21 - std::log(1.1) + 0.5 * kUnitLambda * 0.01,
              1e-12);
}

TEST(StatedMaterial, SimpleShearIsAsComputedByHand) {
  constexpr double kShear = 0.5;
  Eigen::Matrix3d f = Eigen::Matrix3d::Identity();
  f(0, 1) = kShear;
  // Stress B - 1 = [g^2, g; g, 0]: von Mises sqrt(g^4 + 3 g^2); energy g^2 / 2, as the volume is kept.
  EXPECT_NEAR(vonMisesKpa(kUnitShear, stretchOf(f)), std::sqrt(0.0625 + 0.75), 1e-12);
  EXPECT_NEAR(energyKpa(kUnitShear, stretchOf(f)), 0.125, 1e-12);
}

TEST(StatedMaterial, PureShearIsAsComputedByHand) {
  // Squares less one: 3, 0, -3/4.
  EXPECT_NEAR(vonMisesKpa(kUnitShear, {2, 0.5, 1}), std::sqrt(0.5 * (9 + 0.5625 + 14.0625)), 1e-12);
  EXPECT_NEAR(energyKpa(kUnitShear, {2, 0.5, 1}), 0.5 * 2.25, 1e-12);
}

TEST(StatedMaterial, NothingIsFeltOfRigidMotionsAndNoShearOfEvenGrowth) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  EXPECT_LT(vonMisesKpa(kUnitShear, stretchOf(turn)), 1e-13);
  EXPECT_LT(std::abs(energyKpa(kUnitShear, stretchOf(turn))), 1e-13);
  const double grown = 1.2 * 1.2 * 1.2;
  EXPECT_LT(vonMisesKpa(kUnitShear, stretchOf(1.2 * turn)), 1e-12);
  EXPECT_NEAR(energyKpa(kUnitShear, stretchOf(1.2 * turn)),
              0.5 * 3 * 0.44 - std::log(grown) + 0.5 * kUnitLambda * (grown - 1) * (grown - 1), 1e-10);
}

TEST(StatedMaterial, AgreesWithTheTensorsOfTheLaw) {
  const NeoHookean law(6.27, 0.49);
  const StatedMaterial liver = materialOf("liver");
  for (int i = 0; i < 20; ++i) {
    Eigen::Matrix3d f = Eigen::Matrix3d::Identity();
    for (int entry = 0; entry < 9; ++entry)
      f(entry / 3, entry % 3) += 0.25 * std::sin(3.7 * i + 1.3 * entry);
    if (f.determinant() <= 0.1)
      continue;
    EXPECT_NEAR(vonMisesKpa(liver, stretchOf(f)), vonMisesKpa(law, f), 1e-9);
    const double growth = f.determinant() - 1;
    EXPECT_NEAR(energyKpa(liver, stretchOf(f)), law.respond(f).energy + 0.5 * law.bulk() * growth * growth,
                1e-9);
  }
}

TEST(StatedMaterial, WithoutOneThereAreNoPascalsAndFoldedTissueHasNone) {
  const StatedMaterial none;
  EXPECT_FALSE(none.stated());
  EXPECT_TRUE(std::isnan(vonMisesKpa(none, {1.1, 1, 1.1})));
  EXPECT_TRUE(std::isnan(energyKpa(none, {1, 1, 1})));
  EXPECT_TRUE(std::isnan(vonMisesKpa(kUnitShear, {1.1, 0.5, -0.2})));
  EXPECT_TRUE(std::isnan(energyKpa(kUnitShear, {1.1, 0, 0})));
  EXPECT_THROW(materialOf("hair"), UsageError);
  EXPECT_THROW(ownMaterial(0), UsageError);
  EXPECT_THROW(ownMaterial(5, 0.5), UsageError);
  EXPECT_EQ(materialOf("myocardium").tissue, "myocardium");
}

} // namespace
} // namespace viscera::elasticity
