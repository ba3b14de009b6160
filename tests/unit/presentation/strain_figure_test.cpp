#include "viscera/presentation/strain_figure.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

/// What bull's eyes, curves and colours of strain show of a reading.
namespace viscera::presentation {
namespace {

using live::StrainDirection;
using live::StrainMoment;

constexpr int kNone = 5; ///< The segment with too few points.

/// Three phases; segment n shortens by n per cent in the second one. GLS by 12, less than in healthy adults.
live::StrainReading reading() {
  const strain::HeartAxes axes(Vec3::Zero(), Vec3(0, 0, 80), Vec3::UnitX());
  live::StrainReading made(strain::FoundAxes{axes, {}, true, 120});
  made.corresponding = true;
  made.strain.seconds = {0, 0.3, 0.6};
  for (strain::SegmentStrain& segment : made.strain.segments) {
    segment.number = static_cast<int>(&segment - made.strain.segments.data()) + 1;
    segment.enough = segment.number != kNone;
    segment.longitudinal = {0, -0.01 * segment.number, 0};
    segment.circumferential = {0, 0, -0.2};
  }
  strain::ContourStrain gls{"gls", 100, {0, -0.12, -0.05}, {}};
  gls.peak = strain::shortestOf(gls.curve, made.strain.seconds);
  made.strain.gls = gls;
  return made;
}

TEST(StrainFigure, GivesEachVertexTheValueOfItsSegmentInTheBullsEye) {
  const auto eye = strainBullsEye(reading(), StrainDirection::longitudinal, StrainMoment::peak);
  const Values all = strainOnSurface(eye, {3, 0, 17, kNone});
  ASSERT_EQ(all.size(), 4);
  EXPECT_NEAR(all[0], -3, 1e-9);
  EXPECT_TRUE(std::isnan(all[1])) << "no wall of the left ventricle";
  EXPECT_NEAR(all[2], -17, 1e-9);
  EXPECT_TRUE(std::isnan(all[3])) << "too few points";
  const Values chosen = strainOnSurface(eye, {3, 0, 17, kNone}, 17);
  EXPECT_TRUE(std::isnan(chosen[0]));
  EXPECT_NEAR(chosen[2], -17, 1e-9);
}

TEST(StrainFigure, SaysWhetherAPeakLiesInTheRangeOfHealthyAdults) {
  const auto globals = globalStrains(reading());
  ASSERT_EQ(globals.size(), 1U) << "the others are not known";
  EXPECT_EQ(globals[0].name, "GLS");
  EXPECT_NEAR(globals[0].peakPercent, -12, 1e-9);
  EXPECT_NEAR(globals[0].peakMs, 300, 1e-9);
  EXPECT_FALSE(globals[0].healthyPercent.holds(-12));
  EXPECT_TRUE(globals[0].healthyPercent.holds(-17));
  EXPECT_NE(globals[0].norm->source.find("doi"), std::string::npos);
}

TEST(StrainFigure, ShadesTheRangeAndDrawsAChosenSegmentBesideTheWhole) {
  const scene::CurvePanel whole = strainPanel(reading());
  ASSERT_EQ(whole.curves.size(), 1U);
  ASSERT_EQ(whole.bands.size(), 1U);
  EXPECT_EQ(whole.bands[0].color, whole.curves[0].color);
  EXPECT_LT(whole.bands[0].y.low, -17);
  EXPECT_GT(whole.bands[0].y.high, -17);
  const scene::CurvePanel chosen = strainPanel(reading(), 9, StrainDirection::circumferential);
  ASSERT_EQ(chosen.curves.size(), 2U);
  EXPECT_TRUE(chosen.curves[1].dashed);
  EXPECT_NEAR(chosen.curves[1].y[2], -20, 1e-9);
  EXPECT_EQ(strainPanel(reading(), 9, StrainDirection::radial).curves.size(), 1U) << "no wall is known";
}

TEST(StrainFigure, OfTwoReadingsShowsTheDifferenceOfTheirPeaks) {
  live::StrainReading after = reading();
  for (strain::SegmentStrain& segment : after.strain.segments)
    segment.longitudinal[1] -= 0.02;
  const auto eye = strainDifference(after, reading(), StrainDirection::longitudinal);
  EXPECT_NEAR(eye.sectors[6].value.value(), -2, 1e-9);
  EXPECT_FALSE(eye.sectors[kNone - 1].value);
  EXPECT_LT(eye.range.low, 0);
  EXPECT_DOUBLE_EQ(eye.range.low, -eye.range.high) << "white at zero";
}

/// Hatched is what the fit leaves less certain than its distance from the range, and a note says so.
TEST(StrainFigure, HatchesPeaksThatAreUncertainAndDifferencesThatAreSmaller) {
  live::StrainReading fitted = reading();
  EXPECT_TRUE(
      strainBullsEye(fitted, StrainDirection::longitudinal, StrainMoment::peak).sectors[kNone - 1].hatched);
  fitted.deviations.emplace();
  fitted.deviations->longitudinal.fill(0.015);
  const auto eye = strainBullsEye(fitted, StrainDirection::longitudinal, StrainMoment::peak);
  EXPECT_TRUE(eye.sectors[12].hatched) << "13 % is 0.4 from the range";
  EXPECT_FALSE(eye.sectors[5].hatched) << "6 % is far from it";
  EXPECT_FALSE(eye.note.empty());
  live::StrainReading after = fitted;
  for (strain::SegmentStrain& segment : after.strain.segments)
    segment.longitudinal[1] -= segment.number < 9 ? 0.02 : 0.03;
  const auto difference = strainDifference(after, fitted, StrainDirection::longitudinal);
  EXPECT_TRUE(difference.sectors[5].hatched) << "2 points, of two fits that may be off by 1.5 each";
  EXPECT_FALSE(difference.sectors[9].hatched);
}

TEST(StrainFigure, ThickeningIsDrawnLikeStrainAcrossTheWall) {
  live::StrainReading made = reading();
  for (strain::SegmentStrain& segment : made.strain.segments)
    segment.thickening = {0, 0.4, 0.1};
  const auto eye = strainBullsEye(made, StrainDirection::thickening, StrainMoment::peak);
  EXPECT_NEAR(eye.sectors[3].value.value(), 40, 1e-9);
  EXPECT_GT(eye.range.high, 40);
  EXPECT_FALSE(strainBullsEye(reading(), StrainDirection::thickening, StrainMoment::peak).sectors[3].value);
}

} // namespace
} // namespace viscera::presentation
