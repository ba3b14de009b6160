#include "viscera/heart/clinical_numbers.h"

#include <gtest/gtest.h>

namespace viscera::heart {
namespace {

TEST(NormalRanges, EveryRangeHasASourceAndPeopleAndASize) {
  for (const char* organ :
       {"LV", "RV", "Stomach", "liver", "kidney_left", "Right kidney", "Spleen", "pancreas"}) {
    const std::vector<NormalRange> ranges = normalRanges(organ);
    EXPECT_FALSE(ranges.empty()) << organ;
    for (const NormalRange& range : ranges) {
      EXPECT_NE(range.source.find("doi 10."), std::string::npos) << organ << ", " << range.name;
      EXPECT_FALSE(range.people.empty() || range.meaning.empty()) << organ << ", " << range.name;
      EXPECT_LT(0, range.low);
      EXPECT_LT(range.low, range.high) << organ << ", " << range.name;
    }
  }
}

TEST(NormalRanges, OfAVentricleAreThoseOfTheTableForThatPerson) {
  const std::vector<NormalRange> all = normalRanges("lv");
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].quantity, NormalRange::Quantity::endDiastolicMl);
  EXPECT_DOUBLE_EQ(all[0].low, 82);
  EXPECT_DOUBLE_EQ(all[0].high, 230);
  EXPECT_EQ(all[2].quantity, NormalRange::Quantity::ejectionPercent);
  EXPECT_DOUBLE_EQ(all[2].low, 48);
  EXPECT_DOUBLE_EQ(all[2].high, 71);
  const std::vector<NormalRange> women = normalRanges("Right ventricle", {anatomy::Sex::women, 1.6});
  ASSERT_EQ(women.size(), 3u);
  EXPECT_DOUBLE_EQ(women[0].high, 1.6 * (77 + 2 * 13));
  EXPECT_NE(women[0].meaning.english().find("1.60 m2"), std::string::npos) << women[0].meaning;
}

TEST(NormalRanges, AreNotInventedForOtherOrgans) {
  EXPECT_TRUE(normalRanges("Tumour").empty());
  EXPECT_TRUE(normalRanges("").empty());
}

} // namespace
} // namespace viscera::heart
