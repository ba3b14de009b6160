#include "viscera/heart/clinical_numbers.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "viscera/core/error.h"
#include "viscera/sequences/volume_record.h"

namespace viscera::heart {
namespace {

TEST(CardiacIndices, ComeFromTheLargestAndTheSmallestVolume) {
  const CardiacIndices indices = cardiacIndices({112.5, 130.5, 92, 55, 76, 112.5}, 75);
  EXPECT_EQ(indices.endDiastolicMl, 130.5);
  EXPECT_EQ(indices.endSystolicMl, 55);
  EXPECT_DOUBLE_EQ(indices.strokeVolumeMl, 75.5);
  EXPECT_DOUBLE_EQ(indices.ejectionFraction, 75.5 / 130.5);
  EXPECT_DOUBLE_EQ(indices.cardiacOutputLPerMinute, 5.6625);
}

TEST(CardiacIndices, OfAVentricleThatDoesNotMoveAreZero) {
  const CardiacIndices indices = cardiacIndices({80, 80}, 60);
  EXPECT_EQ(indices.ejectionFraction, 0);
  EXPECT_EQ(indices.cardiacOutputLPerMinute, 0);
}

TEST(CardiacIndices, OfNoVolumesOrImpossibleOnesAreRefused) {
  EXPECT_THROW(cardiacIndices({}, 75), DataError);
  EXPECT_THROW(cardiacIndices({100, 0}, 75), DataError);
  EXPECT_THROW(cardiacIndices({100, -5}, 75), DataError);
  EXPECT_THROW(cardiacIndices({100, std::nan("")}, 75), DataError);
  EXPECT_THROW(cardiacIndices({100, 50}, 0), UsageError);
  EXPECT_THROW(cardiacIndices({100, 50}, std::nan("")), UsageError);
}

TEST(VolumeRecord, GivesColumnsOfTheRowsSinceATime) {
  sequences::VolumeRecord record({"LV", "RV"});
  for (int i = 0; i < 4; ++i)
    record.add(0.5 * i, {10.0 + i, 20.0 + i});
  EXPECT_EQ(record.rows(), 4u);
  EXPECT_EQ(record.column(0), (std::vector<double>{10, 11, 12, 13}));
  EXPECT_EQ(record.column(1, 1.0), (std::vector<double>{22, 23}));
}

TEST(VolumeRecord, BeginsAnewWhenTimeGoesBack) {
  sequences::VolumeRecord record({"LV"});
  record.add(1, {1});
  record.add(2, {2});
  record.add(0.5, {3});
  ASSERT_EQ(record.rows(), 1u);
  EXPECT_EQ(record.milliliters(0, 0), 3);
}

TEST(VolumeRecord, KeepsTheLastRowsOfALongPlay) {
  sequences::VolumeRecord record({"LV", "RV"}, 100);
  for (int i = 0; i < 1000; ++i) {
    record.add(i, {1.0 * i, 2.0 * i});
    ASSERT_LE(record.rows(), 200u);
  }
  ASSERT_GE(record.rows(), 100u);
  EXPECT_EQ(record.seconds(record.rows() - 1), 999);
  EXPECT_EQ(record.milliliters(record.rows() - 100, 1), 1800);
}

} // namespace
} // namespace viscera::heart
