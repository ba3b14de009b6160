#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include "viscera/core/error.h"
#include "viscera/scene/picture.h"
#include "viscera/scene/surfaceless_window.h"
#include "viscera/scene/volume_chart.h"

namespace viscera::scene {
namespace {

const ChartLine kRed{"LV", {1, 0, 0}};
const ChartLine kGreen{"RV", {0, 1, 0}, {{{60, 150}, {}}}};

Values two(double a, double b) {
  Values values(2);
  values << a, b;
  return values;
}

/// Pixels of a pure colour left of `x`.
int count(vtkImageData* picture, int channel, int left, int right) {
  int found = 0;
  for (int y = 0; y < picture->GetDimensions()[1]; ++y)
    for (int x = left; x < right; ++x) {
      const auto* p = static_cast<const unsigned char*>(picture->GetScalarPointer(x, y, 0));
      found += p[channel] > 180 && p[(channel + 1) % 3] < 90 && p[(channel + 2) % 3] < 90;
    }
  return found;
}

/// A chart in a picture of its own.
struct DrawnChart {
  SurfacelessWindow surface;
  VolumeChart chart;

  DrawnChart(std::vector<ChartLine> lines, double seconds, int width = 500, const Theme& theme = darkTheme(),
             int height = 200)
      : surface(width, height) {
    chart.setWindow(surface.window());
    chart.setTheme(theme);
    chart.setLines(std::move(lines));
    chart.setTimeRange({0, seconds});
  }

  vtkSmartPointer<vtkImageData> picture() {
    chart.update();
    return grabPicture(surface.window());
  }
};

TEST(VolumeChart, KeepsWhatFitsIntoItsTimeSpan) {
  VolumeChart chart;
  chart.setLines({kRed, kGreen});
  chart.setTimeSpan(4);
  for (int i = 0; i < 1000; ++i)
    chart.append(0.1 * i, two(i, 2 * i));
  EXPECT_GE(chart.pointCount(), 40);
  EXPECT_LE(chart.pointCount(), 62);
  chart.update();
}

TEST(VolumeChart, TimeThatGoesBackDropsWhatCameAfterIt) {
  VolumeChart chart;
  chart.setLines({kRed, kGreen});
  for (const double time : {0.0, 1.0, 2.0, 3.0})
    chart.append(time, two(1, 2));
  chart.append(1.5, two(1, 2));
  EXPECT_EQ(chart.pointCount(), 3);
  chart.append(1.5, two(1, 2));
  EXPECT_EQ(chart.pointCount(), 3) << "the same time again replaces its point";
  chart.clear();
  EXPECT_EQ(chart.pointCount(), 0);
  EXPECT_EQ(chart.lineCount(), 2);
}

TEST(VolumeChart, FixedTimeRangeDropsNothing) {
  VolumeChart chart;
  chart.setLines({kRed, kGreen});
  chart.setTimeRange({0, 1});
  for (int i = 0; i < 500; ++i)
    chart.append(0.1 * i, two(1, 2));
  EXPECT_EQ(chart.pointCount(), 500);
}

TEST(VolumeChart, DrawsNothingWhereANumberStandsAloneAndSaysNothing) {
  DrawnChart drawn({kRed, kGreen}, 10);
  const double gap = std::numeric_limits<double>::quiet_NaN();
  drawn.chart.append(1, two(gap, 80));
  drawn.chart.append(2, two(gap, 90));
  drawn.chart.append(3, two(50, gap));
  testing::internal::CaptureStderr();
  const auto picture = drawn.picture();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_GT(count(picture, 1, 0, 500), 50) << "two neighbours are a line";
  drawn.chart.clear();
  drawn.chart.append(1, two(50, 80));
  testing::internal::CaptureStderr();
  drawn.picture();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(VolumeChart, DrawsItsLinesInTheirColours) {
  DrawnChart drawn({kRed, kGreen}, 10);
  VolumeChart& chart = drawn.chart;
  for (int i = 0; i <= 100; ++i)
    chart.append(0.1 * i, two(100 + 20 * std::sin(0.3 * i), 120 + 20 * std::cos(0.3 * i)));
  // The legend on the right is left out of the count.
  const auto both = drawn.picture();
  EXPECT_GT(count(both, 0, 60, 400), 150);
  EXPECT_GT(count(both, 1, 60, 400), 150);
}

/// The height of the plot, as a part of the picture's.
double plotHeight(int height, const char* title) {
  DrawnChart drawn({kRed}, 1, 500, darkTheme(), height);
  drawn.chart.setAxes(title, "", "Volume", "ml");
  drawn.chart.append(0, Values::Constant(1, 60));
  drawn.chart.append(1, Values::Constant(1, 150));
  drawn.picture();
  const auto cursor = drawn.chart.placeOf(0.5);
  return cursor ? cursor->high - cursor->low : 0;
}

TEST(VolumeChart, GivesTheRoomOfTheTitleBelowItToTheCurvesWhereItIsLow) {
  EXPECT_GT(plotHeight(120, "Time"), 0.6);
  EXPECT_EQ(plotHeight(120, "Time"), plotHeight(120, ""));
  EXPECT_LT(plotHeight(200, "Time"), plotHeight(200, ""));
}

TEST(VolumeChart, WhatRoundingLeavesOfALockedVolumeIsDrawnFlat) {
  const auto redWith = [](double noise) {
    DrawnChart drawn({kRed}, 10);
    VolumeChart& chart = drawn.chart;
    for (int i = 0; i <= 100; ++i)
      chart.append(0.1 * i, Values::Constant(1, 936 * (1 + (i % 2 ? noise : -noise))));
    return count(drawn.picture(), 0, 60, 400);
  };
  // A zigzag between the edges of the chart would take many times the pixels of a line.
  EXPECT_LT(redWith(1e-12), 1.2 * redWith(0));
  EXPECT_GT(redWith(0.1), 3 * redWith(0)) << "a real change is drawn as large as the chart";
}

TEST(VolumeChart, NotANumberIsAGap) {
  DrawnChart drawn({kRed}, 10);
  VolumeChart& chart = drawn.chart;
  for (int i = 0; i <= 100; ++i)
    chart.append(0.1 * i, Values::Constant(1, i > 20 ? std::numeric_limits<double>::quiet_NaN() : 50));
  const auto picture = drawn.picture();
  EXPECT_GT(count(picture, 0, 60, 120), 20);
  EXPECT_EQ(count(picture, 0, 200, 400), 0);
}

TEST(VolumeChart, CursorAndBandAreSeen) {
  DrawnChart drawn({kRed, kGreen}, 10, 400, lightTheme());
  VolumeChart& chart = drawn.chart;
  const auto without = drawn.picture();
  chart.setCursor(5);
  const double cursor = comparePictures(without, drawn.picture()).differing;
  EXPECT_GT(cursor, 0.001);
  EXPECT_LT(cursor, 0.03);
}

TEST(VolumeChart, TheCursorIsDrawnWhereItsPlaceIsSaidToBe) {
  DrawnChart drawn({kRed}, 10, 400, lightTheme());
  VolumeChart& chart = drawn.chart;
  EXPECT_FALSE(VolumeChart().placeOf(5)) << "never drawn";
  for (const double time : {0.0, 5.0, 10.0})
    chart.append(time, Values::Constant(1, 50));
  const auto without = drawn.picture();
  for (const double time : {1.0, 5.0, 9.0}) {
    chart.setCursor(time);
    const auto with = drawn.picture();
    const auto place = chart.placeOf(time);
    ASSERT_TRUE(place);
    double columns = 0, sum = 0, lowest = 200, highest = 0;
    for (int y = 0; y < 200; ++y)
      for (int x = 0; x < 400; ++x)
        if (*static_cast<unsigned char*>(with->GetScalarPointer(x, y, 0)) + 40 <
            *static_cast<unsigned char*>(without->GetScalarPointer(x, y, 0))) {
          ++columns;
          sum += x + 0.5;
          lowest = std::min<double>(lowest, y);
          highest = std::max<double>(highest, y);
        }
    EXPECT_NEAR(400 * place->x, sum / columns, 1) << time;
    EXPECT_NEAR(200 * place->low, lowest, 2);
    EXPECT_NEAR(200 * place->high, highest, 2);
  }
  EXPECT_FALSE(chart.placeOf(11)) << "beyond the axis";
}

TEST(VolumeChart, ACurveMayHaveTimesOfItsOwnUntilItIsCleared) {
  DrawnChart drawn({kRed, kGreen}, 1);
  VolumeChart& chart = drawn.chart;
  chart.setCurve(0, {0, 0.1, 0.3}, {50, 60, 70});
  chart.setCurve(1, {0.5, 1}, {80, 90});
  const auto picture = drawn.picture();
  EXPECT_GT(count(picture, 0, 40, 200), 30);
  EXPECT_EQ(count(picture, 0, 220, 400), 0) << "the red curve ends at a third of the width";
  EXPECT_GT(count(picture, 1, 220, 400), 30);
  EXPECT_THROW(chart.setCurve(0, {0, 1}, {1}), UsageError);
  chart.clear();
  for (const double time : {0.0, 0.5, 1.0})
    chart.append(time, two(50, 60));
  EXPECT_GT(count(drawn.picture(), 0, 220, 400), 30) << "the common times are back";
}

TEST(VolumeChart, OtherBandsLeaveTheCurvesAsTheyAre) {
  DrawnChart drawn({kRed}, 1);
  VolumeChart& chart = drawn.chart;
  for (const double time : {0.0, 0.5, 1.0})
    chart.append(time, Values::Constant(1, 50));
  const auto without = drawn.picture();
  chart.setBands(0, {{{45, 55}, "normal"}});
  const auto with = drawn.picture();
  EXPECT_EQ(chart.pointCount(), 3);
  EXPECT_GT(comparePictures(without, with, 4).differing, 0.1);
  chart.setBands(0, {});
  EXPECT_LT(comparePictures(without, drawn.picture(), 4).differing, 0.001);
}

TEST(VolumeChart, ABandThatWouldFlattenItsCurveIsLeftOutOfThePicture) {
  DrawnChart drawn({kRed}, 1);
  for (int i = 0; i <= 40; ++i)
    drawn.chart.append(i / 40.0, Values::Constant(1, 50 + 0.25 * i));
  const auto without = drawn.picture();
  drawn.chart.setBands(0, {{{600, 900}, {}}});
  EXPECT_LT(comparePictures(without, drawn.picture(), 4).differing, 0.01);
  drawn.chart.setBands(0, {{{40, 70}, {}}});
  EXPECT_GT(comparePictures(without, drawn.picture(), 4).differing, 0.1);
}

TEST(VolumeChart, CurvesThatVaryHaveMostOfTheHeightBesideLongBands) {
  DrawnChart drawn({kRed}, 1);
  for (int i = 0; i <= 40; ++i)
    drawn.chart.append(i / 40.0, Values::Constant(1, i <= 20 ? 130 : 55));
  drawn.chart.setBands(0, {{{82, 230}, {}}, {{27, 101}, {}}});
  const auto picture = drawn.picture();
  int lowest = 200, highest = 0;
  for (int y = 0; y < 200; ++y)
    for (int x = 60; x < 440; ++x) {
      const auto* p = static_cast<const unsigned char*>(picture->GetScalarPointer(x, y, 0));
      if (p[0] > 180 && p[1] < 90 && p[2] < 90) {
        lowest = std::min(lowest, y);
        highest = std::max(highest, y);
      }
    }
  const auto place = drawn.chart.placeOf(0.5);
  ASSERT_TRUE(place);
  EXPECT_GT(highest - lowest, 0.45 * 200 * (place->high - place->low));
}

/// The rows in which letters of a pure colour, as names have it, stand right of the curves.
std::set<int> nameRows(vtkImageData* picture, int channel) {
  std::set<int> rows;
  const int width = picture->GetDimensions()[0];
  for (int y = 0; y < picture->GetDimensions()[1]; ++y)
    for (int x = width - 40; x < width; ++x) {
      const auto* p = static_cast<const unsigned char*>(picture->GetScalarPointer(x, y, 0));
      if (p[channel] > 150 && p[channel] > p[(channel + 1) % 3] + 60 &&
          p[channel] > p[(channel + 2) % 3] + 60)
        rows.insert(y);
    }
  return rows;
}

TEST(VolumeChart, NamesStandAtTheEndsOfTheirCurves) {
  for (const bool redAbove : {true, false}) {
    DrawnChart drawn({{"first", {1, 0, 0}}, {"second", {0, 1, 0}}}, 1);
    for (const double time : {0.0, 0.5, 1.0})
      drawn.chart.append(time, redAbove ? two(90, 10) : two(10, 90));
    const auto picture = drawn.picture();
    const auto red = nameRows(picture, 0), green = nameRows(picture, 1);
    ASSERT_FALSE(red.empty());
    ASSERT_FALSE(green.empty());
    EXPECT_GT(*(redAbove ? red : green).begin(), 120);
    EXPECT_LT(*(redAbove ? green : red).rbegin(), 80);
  }
}

TEST(VolumeChart, NamesOfCurvesThatEndTogetherStandBelowEachOther) {
  for (const double end : {0.0, 50.0, 100.0}) {
    DrawnChart drawn({{"first", {1, 0, 0}}, {"second", {0, 1, 0}}, {"third", {0, 0, 1}}}, 1);
    Values last(3);
    last << end, end + 0.1, end + 0.2;
    drawn.chart.append(0, Values::LinSpaced(3, 0, 100));
    drawn.chart.append(1, last);
    const auto picture = drawn.picture();
    const auto red = nameRows(picture, 0), green = nameRows(picture, 1);
    ASSERT_FALSE(red.empty());
    ASSERT_FALSE(green.empty());
    EXPECT_LT(*red.rbegin(), *green.begin()) << end;
  }
}

TEST(VolumeChart, TheSecondAxisHasItsCurvesColour) {
  const auto redAt = [](bool right) {
    DrawnChart drawn({{"", {1, 0, 0}, {}, right}, {"", {0, 1, 0}}}, 1, 500, lightTheme());
    for (const double time : {0.0, 0.4})
      drawn.chart.append(time, two(50, 60));
    const auto picture = drawn.picture();
    int red = 0;
    for (int y = 0; y < 200; ++y)
      for (int x = 460; x < 500; ++x) {
        const auto* p = static_cast<const unsigned char*>(picture->GetScalarPointer(x, y, 0));
        red += p[0] > p[1] + 60 && p[0] > p[2] + 60;
      }
    return red;
  };
  EXPECT_EQ(redAt(false), 0);
  EXPECT_GT(redAt(true), 60) << "its numbers";
}

TEST(VolumeChart, TheCaptionOfABandStandsWhereNoCurvePasses) {
  DrawnChart drawn({kRed}, 1);
  VolumeChart& chart = drawn.chart;
  // Through the middle of the band at the left, where a caption would stand, and out of it at the right.
  for (int i = 0; i <= 40; ++i)
    chart.append(i / 40.0, Values::Constant(1, i < 20 ? 50 : 50 + 2.5 * (i - 20)));
  const auto differing = [&](const std::string& caption) {
    chart.setBands(0, {{{30, 70}, {}}});
    const auto without = drawn.picture();
    chart.setBands(0, {{{30, 70}, caption}});
    const auto with = drawn.picture();
    int changed = 0, onCurve = 0;
    for (int y = 1; y < 199; ++y)
      for (int x = 60; x < 490; ++x) {
        const auto at = [&](vtkImageData* picture, int dy) {
          return static_cast<const unsigned char*>(picture->GetScalarPointer(x, y + dy, 0));
        };
        if (std::abs(at(without, 0)[1] - at(with, 0)[1]) < 16)
          continue;
        ++changed;
        for (const int dy : {-1, 0, 1})
          onCurve += at(without, dy)[0] > 200 && at(without, dy)[1] < 60;
      }
    return std::pair{changed, onCurve};
  };
  const auto [changed, onCurve] = differing("normal");
  EXPECT_GT(changed, 40) << "it is there";
  EXPECT_EQ(onCurve, 0);
  EXPECT_EQ(differing(std::string(200, 'm')).first, 0) << "there is no room for this one";
}

TEST(VolumeChart, OtherBandsOfEmptyCurvesSayNothing) {
  DrawnChart drawn({kRed, kGreen}, 1);
  drawn.picture();
  drawn.chart.setBands(0, {{{45, 55}, "normal"}});
  testing::internal::CaptureStderr();
  grabPicture(drawn.surface.window());
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "drawn before it was brought up to date";
}

TEST(VolumeChart, WritesDecimalsWithTheMarkOfTheLanguage) {
  DrawnChart drawn({kRed}, 1);
  for (const double time : {0.0, 0.5, 1.0})
    drawn.chart.append(time, Values::Constant(1, time));
  const auto point = drawn.picture();
  drawn.chart.setDecimalMark(',');
  const auto comma = drawn.picture();
  int changed = 0;
  const int* size = point->GetDimensions();
  for (int y = 0; y < size[1]; ++y)
    for (int x = 0; x < size[0]; ++x)
      changed +=
          point->GetScalarComponentAsDouble(x, y, 0, 0) != comma->GetScalarComponentAsDouble(x, y, 0, 0);
  EXPECT_GT(changed, 0);
  EXPECT_LT(changed, 400) << "nothing but the marks";
}

TEST(VolumeChart, EmptyAndSinglePointAreOrdinaryStates) {
  SurfacelessWindow surface(300, 150);
  VolumeChart chart;
  chart.setWindow(surface.window());
  surface.window()->Render();
  chart.setLines({kRed, kGreen});
  chart.update();
  surface.window()->Render();
  chart.append(0, two(3, 4));
  chart.update();
  surface.window()->Render();
  chart.setLines({});
  chart.update();
  surface.window()->Render();
  EXPECT_EQ(chart.lineCount(), 0);
}

} // namespace
} // namespace viscera::scene
