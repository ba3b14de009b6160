#include "viscera/heart/heart_numbers.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "viscera/core/error.h"

namespace viscera::heart {
namespace {

const std::vector<double> kBeatFractions = {0, 0.25, 0.5, 0.75};
const std::vector<double> kBeatVolumes = {120, 80, 50, 90};

TEST(CycleEnds, AreFoundUnlessTheUserHasChosen) {
  EXPECT_EQ(cycleEnds(kBeatFractions, kBeatVolumes), (CycleEnds{0, 0.5}));
  EXPECT_EQ(cycleEnds(kBeatFractions, kBeatVolumes, {std::nullopt, 0.25}), (CycleEnds{0, 0.25}));
  EXPECT_EQ(cycleEnds(kBeatFractions, kBeatVolumes, {0.75, std::nullopt}), (CycleEnds{0.75, 0.5}));
  EXPECT_THROW(cycleEnds({}, {}), UsageError);
  EXPECT_THROW(cycleEnds({0, 0.5}, {1}), UsageError);
}

TEST(CycleEnds, GiveTheIndicesOfTheirInstants) {
  const CardiacIndices found =
      cardiacIndicesAt(cycleEnds(kBeatFractions, kBeatVolumes), kBeatFractions, kBeatVolumes, 60);
  EXPECT_EQ(found.endDiastolicMl, 120);
  EXPECT_EQ(found.endSystolicMl, 50);
  EXPECT_DOUBLE_EQ(found.cardiacOutputLPerMinute, 4.2);
  const CardiacIndices chosen = cardiacIndicesAt({0.875, 0.375}, kBeatFractions, kBeatVolumes, 60);
  EXPECT_DOUBLE_EQ(chosen.endDiastolicMl, 105) << "between the last phase and the first";
  EXPECT_DOUBLE_EQ(chosen.endSystolicMl, 65);
  EXPECT_DOUBLE_EQ(chosen.ejectionFraction, 40.0 / 105);
  EXPECT_DOUBLE_EQ(cardiacIndicesAt({1, 0.5}, {0, 0.5, 1}, {110, 60, 110}, 60).endDiastolicMl, 110);
  EXPECT_THROW(cardiacIndicesAt({0, 0.5}, kBeatFractions, {0, 1, 2, 3}, 60), DataError);
}

TEST(BodySurface, IsMostellers) {
  EXPECT_NEAR(bodySurfaceM2(180, 80), 2.0, 1e-12);
  EXPECT_NEAR(bodySurfaceM2(165, 60), 1.6583, 1e-4);
  EXPECT_THROW(bodySurfaceM2(1.8, 80), UsageError) << "metres";
  EXPECT_THROW(bodySurfaceM2(180, 0), UsageError);
}

TEST(MuscleGrams, AreThoseOfTheMyocardiumIfThereIsOne) {
  EXPECT_FALSE(muscleGrams({{"LV", 120}, {"Liver", 1500}}));
  EXPECT_DOUBLE_EQ(muscleGrams({{"LV", 120}, {"Myocardium", 100}}).value(), 105);
}

TEST(HeartNumbers, AreIndexedByTheBodySurface) {
  CardiacIndices indices{150, 60, 90, 0.6, 5.4};
  const std::vector<HeartNumber> numbers = heartNumbers(indices, 120, 2);
  ASSERT_EQ(numbers.size(), 6u);
  EXPECT_EQ(numbers[0].id, "edv");
  EXPECT_EQ(numbers[0].perM2, 75);
  EXPECT_EQ(numbers[3].value, 60);
  EXPECT_FALSE(numbers[3].perM2) << "an ejection fraction has no size";
  EXPECT_EQ(numbers[4].perM2, 2.7);
  EXPECT_EQ(numbers[5].perM2, 60);
  EXPECT_EQ(heartNumbers(indices, std::nullopt, 2).size(), 5u);
  for (const HeartNumber& number : heartNumbers(indices, 120, 0))
    EXPECT_FALSE(number.perM2) << number.id;
}

TEST(HeartNumbers, AreWrittenAsCsv) {
  const std::string csv =
      heartNumbersCsv({{"LV, \"left\"", heartNumbers({150, 60, 90, 0.6, 5.4}, std::nullopt, 2)}});
  EXPECT_EQ(csv, "organ,number,value,unit,value_per_m2\n"
                 "\"LV, \"\"left\"\"\",edv,150,ml,75\n"
                 "\"LV, \"\"left\"\"\",esv,60,ml,30\n"
                 "\"LV, \"\"left\"\"\",sv,90,ml,45\n"
                 "\"LV, \"\"left\"\"\",ef,60,%,\n"
                 "\"LV, \"\"left\"\"\",co,5.4,l/min,2.7\n");
}

} // namespace
} // namespace viscera::heart
