#include "viscera/presentation/stress_values.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "viscera/presentation/stress_look.h"

namespace viscera::presentation {
namespace {

using Quantity = live::StressQuantity;
using Range = scene::ValueRange;

/// Asks for a logarithmic range without one before.
constexpr Range kLogarithmic{0, 0, true};

TEST(LogarithmicRange, OfAnAngleBeginsBelowTheBulkWithinThreeDecades) {
  EXPECT_EQ(steppedRange(Quantity::rotationalStress, {0.4, 11}, kLogarithmic), (Range{0.2, 20, true}));
  EXPECT_EQ(steppedRange(Quantity::rotationalStress, {0, 11}, kLogarithmic), (Range{0.02, 20, true}));
  EXPECT_EQ(steppedRange(Quantity::rotationalStress, {9, 11}, kLogarithmic), (Range{2, 20, true}))
      << "a decade at least";
  EXPECT_EQ(steppedRange(Quantity::rotationalStress, {0, 1e-13}, kLogarithmic), (Range{0.001, 1, true}))
      << "at rest";
}

TEST(LogarithmicRange, DoesNotCreep) {
  const Range first = steppedRange(Quantity::rotationalStress, {0.4, 11}, kLogarithmic);
  for (const Range bulk : {Range{0.3, 12}, Range{0.9, 9}, Range{0.25, 13}})
    EXPECT_EQ(steppedRange(Quantity::rotationalStress, bulk, first), first);
  EXPECT_LT(steppedRange(Quantity::rotationalStress, {0.05, 11}, first).low, first.low);
  EXPECT_GT(steppedRange(Quantity::rotationalStress, {0.4, 20}, first).high, first.high);
  EXPECT_FALSE(steppedRange(Quantity::rotationalStress, {0.4, 11}, {0, 20}).logarithmic);
}

TEST(LogarithmicRange, OfARatioGoesByOneFactorUpAndDown) {
  for (const Range bulk : {Range{0.8, 1.25}, Range{0.9, 1.3}, Range{0.7, 1}}) {
    const Range range = steppedRange(Quantity::volumeRatio, bulk, kLogarithmic);
    EXPECT_TRUE(range.logarithmic);
    EXPECT_NEAR(range.low * range.high, 1, 1e-12);
    EXPECT_LE(range.low, bulk.low);
    EXPECT_GE(range.high, bulk.high);
    EXPECT_EQ(steppedRange(Quantity::volumeRatio, bulk, range), range);
  }
  EXPECT_EQ(steppedRange(Quantity::folded, {0, 1}, kLogarithmic), (Range{0, 1}));
}

TEST(LogarithmicRange, OfARangeThatIsKeptBringsItsLowerEndAboveZero) {
  EXPECT_EQ(onScale(Quantity::rotationalStress, {0, 20}, true), (Range{0.02, 20, true}));
  EXPECT_EQ(onScale(Quantity::rotationalStress, {1, 20}, true), (Range{1, 20, true}));
  EXPECT_EQ(onScale(Quantity::volumeRatio, {0, 2}, true), (Range{0.5, 2, true}));
  EXPECT_EQ(onScale(Quantity::rotationalStress, {1, 20, true}, false), (Range{1, 20}));
  EXPECT_EQ(onScale(Quantity::folded, {0, 1}, true), (Range{0, 1}));
}

TEST(LogarithmicRange, IsAPartOfTheLook) {
  StressLook look;
  look.logarithmic = true;
  look.range = {0.2, 20, true};
  EXPECT_EQ(stressLookFromJson(toJson(look)), look);
  EXPECT_FALSE(stressLookFromJson("{}").logarithmic) << "sessions of before have none";
}

TEST(LogarithmicRange, IsWrittenAsItIsRead) {
  StressLook look;
  look.logarithmic = true;
  look.range = {0, 1}; // Of the linear scale before.
  const std::string written = toJson(look);
  EXPECT_EQ(toJson(stressLookFromJson(written)), written);
}

TEST(StressColors, AreChosenForAnglesAndRatiosApartAndAPartOfTheLook) {
  StressLook look;
  look.*colorsOf(Quantity::rotationalStress) = "cividis";
  EXPECT_EQ(look.*colorsOf(Quantity::volumeRatio), "diverging");
  look.*colorsOf(Quantity::stretchMin) = "grey";
  EXPECT_EQ(look.*colorsOf(Quantity::stretchMax), "grey") << "ratios have one choice";
  EXPECT_EQ(stressLookFromJson(toJson(look)), look);
  EXPECT_EQ(stressLookFromJson(R"({"amountColors": "jet"})"), StressLook())
      << "an unknown map is not refused";
}

TEST(TissueRange, GoesByDecadesOfOneTwoFive) {
  EXPECT_EQ(steppedRange(Quantity::vonMises, {0, 0.25}, {0, 0}), (Range{0, 0.5}));
  EXPECT_EQ(steppedRange(Quantity::vonMises, {0, 90}, {0, 0}), (Range{0, 200}));
  EXPECT_EQ(steppedRange(Quantity::energy, {0, 0}, {0, 0}), (Range{0, 0.001})) << "at rest";
}

TEST(TissueRange, TheMaterialIsAPartOfTheLookAndNoHabit) {
  StressLook look;
  look.quantity = Quantity::energy;
  look.material = elasticity::materialOf("liver", 0.45);
  EXPECT_EQ(stressLookFromJson(toJson(look)), look);
  EXPECT_EQ(stressLookFromJson(R"({"material": {"tissue": "liver", "youngKpa": -3}})").material,
            elasticity::StatedMaterial())
      << "a number that is no material states none";
  EXPECT_FALSE(habitOf(look).material.stated());
  EXPECT_EQ(habitOf(look).quantity, Quantity::rotationalStress);
}

TEST(StressColors, HaveNoMagentaBesidesTheFolded) {
  for (const scene::ColorMap& map : scene::colorMaps()) {
    const scene::ColorMap colors = stressColors(map.name);
    EXPECT_EQ(colors.colors, map.colors);
    double nearest = 1e9;
    for (Eigen::Index i = 0; i < colors.colors.rows(); ++i) {
      double distance = 0;
      for (int c = 0; c < 3; ++c)
        distance += std::pow(double(colors.colors(i, c)) - colors.missing[static_cast<std::size_t>(c)], 2);
      nearest = std::min(nearest, std::sqrt(distance));
    }
    EXPECT_GT(nearest, 90) << map.name;
  }
}

/// Witness points whose tissue is turned by that many degrees and has that part of its volume.
live::StressFrame frameOf(const deformation::WitnessMesh& mesh, deformation::StressMap& map, double degrees,
                          double volumeRatio) {
  const auto count = mesh.points.rows();
  map.rotationalStress = Values::Constant(count, degrees * M_PI / 180);
  map.volumeRatio = Values::Constant(count, volumeRatio);
  map.stretchMax = map.stretchMin = Values::Ones(count);
  live::StressFrame frame;
  frame.mesh = std::shared_ptr<const deformation::WitnessMesh>(&mesh, [](const auto*) {});
  frame.map = std::shared_ptr<const deformation::StressMap>(&map, [](const auto*) {});
  return frame;
}

TEST(LegendOfStress, HasNoScaleAtRestAndTheRangeWhereSomethingIsDeformed) {
  deformation::WitnessMesh mesh;
  mesh.points = Points::Zero(20, 3);
  mesh.witnesses = 20;
  deformation::StressMap map;
  StressValues values;
  StressLook look;
  values.update(frameOf(mesh, map, 1e-9, 1), look);
  EXPECT_FALSE(values.deformed());
  EXPECT_EQ(values.legendRange(), (Range{0, 0})) << "no angle is invented";
  look.quantity = Quantity::volumeRatio;
  values.update(frameOf(mesh, map, 0, 1 + 1e-12), look);
  EXPECT_EQ(values.legendRange(), (Range{1, 1}));
  values.update(frameOf(mesh, map, 0, 1.2), look);
  EXPECT_TRUE(values.deformed());
  EXPECT_EQ(values.legendRange(), values.range());
  look.quantity = Quantity::rotationalStress;
  values.update(frameOf(mesh, map, 4, 1), look);
  EXPECT_TRUE(values.deformed());
  EXPECT_GT(values.legendRange().high, 4);
  look.pinned = true;
  look.range = {0, 20};
  values.update(frameOf(mesh, map, 0, 1), look);
  EXPECT_EQ(values.legendRange(), (Range{0, 20})) << "the user's own range";
}

TEST(TissueRange, NothingIsShownBeforeAMaterialIsChosen) {
  deformation::WitnessMesh mesh;
  mesh.points = Points::Zero(4, 3);
  mesh.witnesses = 4;
  deformation::StressMap map;
  const live::StressFrame frame = frameOf(mesh, map, 10, 1);
  StressLook look;
  look.quantity = Quantity::vonMises;
  StressValues values;
  values.update(frame, look);
  EXPECT_FALSE(values.ready());
  look.material = elasticity::materialOf("liver");
  values.update(frame, look);
  EXPECT_TRUE(values.ready());
  EXPECT_EQ(values.measure().material.tissue, "liver");
}

} // namespace
} // namespace viscera::presentation
