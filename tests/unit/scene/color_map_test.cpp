#include <cmath>
#include <limits>
#include <set>

#include <gtest/gtest.h>
#include <vtkLookupTable.h>

#include "viscera/core/error.h"
#include "viscera/scene/color_map.h"

namespace viscera::scene {
namespace {

/// CIE 1976 lightness of a colour of 0 to 255, 0 to 100.
double lightness(const ColorMap& map, Eigen::Index row) {
  double y = 0;
  const double weights[] = {0.2126, 0.7152, 0.0722};
  for (int c = 0; c < 3; ++c) {
    const double s = map.colors(row, c) / 255.0;
    y += weights[c] * (s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
  }
  return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

TEST(ColorMap, OfAmountsGetsLighterEvenlyFromEndToEnd) {
  for (const ColorMap& map : colorMaps()) {
    if (map.name == "diverging")
      continue;
    SCOPED_TRACE(map.name);
    ASSERT_EQ(map.colors.rows(), 256);
    const double whole = lightness(map, 255) - lightness(map, 0);
    EXPECT_GT(whole, 70);
    for (Eigen::Index i = 16; i < 256; i += 16) {
      const double step = lightness(map, i) - lightness(map, i - 16);
      EXPECT_NEAR(step, whole / 16, 0.5 * whole / 16) << i;
    }
  }
}

TEST(ColorMap, DivergingIsLightestInTheMiddleAndAsDarkAtBothEnds) {
  const auto map = diverging();
  const Eigen::Index last = map.colors.rows() - 1;
  for (Eigen::Index i = 8; i <= last / 2; i += 8) {
    EXPECT_GT(lightness(map, i), lightness(map, i - 8));
    EXPECT_GT(lightness(map, last - i), lightness(map, last - i + 8));
  }
  EXPECT_NEAR(lightness(map, 0), lightness(map, last), 6);
  EXPECT_GT(map.colors(0, 2), map.colors(0, 0)) << "low is blue";
  EXPECT_GT(map.colors(last, 0), map.colors(last, 2)) << "high is red";
}

TEST(ColorMap, MapsAreFoundByNameAndOthersRefused) {
  for (const auto& map : {viridis(), diverging()})
    EXPECT_EQ(colorMapByName(map.name).colors, map.colors);
  std::set<std::string> names, titles;
  for (const ColorMap& map : colorMaps()) {
    names.insert(map.name);
    titles.insert(map.title);
    EXPECT_EQ(&colorMapByName(map.name), &map);
  }
  EXPECT_EQ(names.size(), colorMaps().size());
  EXPECT_EQ(titles.size(), colorMaps().size());
  EXPECT_THROW(colorMapByName("jet"), UsageError);
}

TEST(ColorMap, RangesIgnoreWhatIsNotANumberAndAreNeverEmpty) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Values values(4);
  values << nan, -2, 5, std::numeric_limits<double>::infinity();
  EXPECT_EQ(rangeOf(values).low, -2);
  EXPECT_EQ(rangeOf(values).high, 5);
  for (const double constant : {0.0, 3.0, nan}) {
    const auto range = rangeOf(Values::Constant(3, constant));
    EXPECT_LT(range.low, range.high);
  }
}

TEST(ColorMap, TableGivesTheEndsBeyondTheRangeAndGreyForNoNumber) {
  const auto map = viridis();
  const auto table = lookupTable(map, {10, 20});
  const auto same = [&](double value, Eigen::Index row) {
    const unsigned char* rgba = table->MapValue(value);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(rgba[c], map.colors(row, c), 1);
  };
  same(-100, 0);
  same(10, 0);
  same(20, 255);
  same(1e9, 255);
  const unsigned char* none = table->MapValue(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(none[0], none[1]);
  EXPECT_EQ(none[1], none[2]);
}

TEST(ColorMap, OfALogarithmicRangeGoesByFactors) {
  const ValueRange range{0.1, 10, true};
  EXPECT_NEAR(partOf(range, 1), 0.5, 1e-12);
  EXPECT_EQ(partOf(range, 0.1), 0);
  EXPECT_LT(partOf(range, 0), -1e300);
  EXPECT_NEAR(partOf({0, 4}, 1), 0.25, 1e-12);
  for (const double part : {0.0, 0.3, 1.0}) {
    EXPECT_NEAR(partOf(range, valueAt(range, part)), part, 1e-12);
    EXPECT_NEAR(partOf({-2, 3}, valueAt({-2, 3}, part)), part, 1e-12);
  }
  const auto map = viridis();
  const auto table = lookupTable(map, range);
  const auto same = [&](double value, Eigen::Index row) {
    const unsigned char* rgba = table->MapValue(value);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(rgba[c], map.colors(row, c), 1) << value;
  };
  for (const double below : {0.1, 0.01, 0.0, -3.0})
    same(below, 0);
  same(1, 128);
  same(10, 255);
  same(1e6, 255);
}

} // namespace
} // namespace viscera::scene
