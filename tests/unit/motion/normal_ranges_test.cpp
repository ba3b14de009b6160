#include "viscera/motion/clinical_numbers.h"

#include <gtest/gtest.h>

namespace viscera::motion {
namespace {

TEST(NormalRanges, EveryRangeHasASourceAndPeopleAndASize) {
  for (const char* organ : {"LV", "RV", "Stomach"}) {
    const std::vector<NormalRange> ranges = normalRanges(organ);
    EXPECT_FALSE(ranges.empty()) << organ;
    for (const NormalRange& range : ranges) {
      EXPECT_NE(range.source.find("doi 10."), std::string::npos) << organ << ", " << range.name;
      EXPECT_FALSE(range.people.empty()) << organ << ", " << range.name;
      EXPECT_LT(0, range.low);
      EXPECT_LT(range.low, range.high) << organ << ", " << range.name;
    }
  }
}

TEST(NormalRanges, OfTheLeftVentricleReachFromSmallWomenToLargeMen) {
  const std::vector<NormalRange> ranges = normalRanges("lv");
  ASSERT_GE(ranges.size(), 2u);
  EXPECT_EQ(ranges[0].quantity, NormalRange::Quantity::endDiastolicMl);
  EXPECT_DOUBLE_EQ(ranges[0].low, 135 - 26);
  EXPECT_DOUBLE_EQ(ranges[0].high, 160 + 29);
  EXPECT_EQ(ranges[1].quantity, NormalRange::Quantity::endSystolicMl);
  EXPECT_DOUBLE_EQ(ranges[1].low, 42 - 12);
  EXPECT_DOUBLE_EQ(ranges[1].high, 50 + 16);
}

TEST(NormalRanges, AreNotInventedForOtherOrgans) {
  EXPECT_TRUE(normalRanges("Spleen").empty());
  EXPECT_TRUE(normalRanges("").empty());
}

} // namespace
} // namespace viscera::motion
