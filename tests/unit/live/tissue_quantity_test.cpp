#include <cmath>

#include <gtest/gtest.h>

#include "viscera/live/stress_quantity.h"
#include "viscera/live/stress_reading.h"

namespace viscera::live {
namespace {

/// A point that is sheared, and a folded one.
deformation::StressMap shearedMap() {
  deformation::StressMap map;
  map.rotationalStress = Eigen::Vector2d(0.6, 1);
  map.stretchMax = Eigen::Vector2d(2, 2);
  map.stretchMin = Eigen::Vector2d(0.5, 0.1);
  map.volumeRatio = Eigen::Vector2d(1, -0.1);
  return map;
}

const elasticity::StatedMaterial kOneShear = elasticity::ownMaterial(2.98, 0.49);

TEST(TissueQuantity, HasNumbersOfAStatedMaterialOnly) {
  Values values;
  for (const StressQuantity quantity : {StressQuantity::vonMises, StressQuantity::energy}) {
    EXPECT_FALSE(StressMeasure(quantity).known());
    quantityOf(shearedMap(), quantity, values);
    EXPECT_TRUE(std::isnan(values[0]));
    EXPECT_TRUE(StressMeasure(quantity, kOneShear).known());
  }
  quantityOf(shearedMap(), {StressQuantity::vonMises, kOneShear}, values);
  EXPECT_NEAR(values[0], std::sqrt(0.5 * (9 + 0.5625 + 14.0625)), 1e-12);
  EXPECT_TRUE(std::isnan(values[1])) << "it is folded";
  quantityOf(shearedMap(), {StressQuantity::energy, kOneShear}, values);
  EXPECT_NEAR(values[0], 1.125, 1e-12);
}

TEST(TissueQuantity, SaysItsMaterialBehindItsUnit) {
  const elasticity::StatedMaterial liver = elasticity::materialOf("liver");
  const StressMeasure measure(StressQuantity::vonMises, liver);
  EXPECT_EQ(measure.unit().english(), "kPa, liver (E 6.27 kPa)");
  EXPECT_EQ(measure.shortUnit().english(), "kPa, liver");
  EXPECT_EQ(StressMeasure(StressQuantity::energy, elasticity::ownMaterial(5)).unit().english(),
            "kPa, E 5 kPa");
  EXPECT_EQ(StressMeasure(StressQuantity::rotationalStress, liver).unit().english(), "deg");
  EXPECT_TRUE(StressMeasure(StressQuantity::volumeRatio, liver).unit().empty());
}

TEST(TissueQuantity, OfExtremesIsTheirsAndTheEnergyOfTheirPoissonRatioOnly) {
  deformation::StressMap map = shearedMap();
  map.extremes = std::make_shared<const deformation::TissueExtremes>(
      deformation::TissueExtremes{Eigen::Vector2d(3, 0), Eigen::Vector2d(4, 0), 0.49});
  EXPECT_NEAR(quantityAt(map, {StressQuantity::vonMises, kOneShear}, 0), 3, 1e-12);
  EXPECT_NEAR(quantityAt(map, {StressQuantity::energy, kOneShear}, 0), 4, 1e-12);
  EXPECT_TRUE(std::isnan(quantityAt(map, {StressQuantity::energy, elasticity::ownMaterial(2.98, 0.4)}, 0)));
}

TEST(TissueQuantity, OfAReadingIsThatOfItsStretches) {
  StressReading reading;
  reading.inTissue = true;
  reading.stretchMax = 2;
  reading.stretchMin = 0.5;
  reading.volumeRatio = 1;
  EXPECT_NEAR(valueOf(reading, {StressQuantity::energy, kOneShear}), 1.125, 1e-12);
  EXPECT_TRUE(std::isnan(valueOf(reading, StressQuantity::energy)));
}

} // namespace
} // namespace viscera::live
