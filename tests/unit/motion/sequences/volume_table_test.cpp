#include "viscera/sequences/volume_record.h"

#include <gtest/gtest.h>

#include "temporary_folder.h"
#include "viscera/core/error.h"

namespace viscera::sequences {
namespace {

TEST(VolumeTable, HasOneColumnAnOrganAndOneRowAnInstant) {
  VolumeRecord record({"LV", "Heart, \"left\""});
  record.add(0, {130.5, 938.25});
  record.add(0.04, {129, 937});
  const tests::TemporaryFolder folder;
  writeVolumeTable(folder / "volumes.csv", record);
  EXPECT_EQ(tests::contentsOf(folder / "volumes.csv"), "time_s,LV_ml,\"Heart, \"\"left\"\"_ml\"\n"
                                                       "0,130.5,938.25\n"
                                                       "0.04,129,937\n");
}

TEST(VolumeTable, HasChambersOnceMoreByTheirKeysButACurveHasTwoColumns) {
  const tests::TemporaryFolder folder;
  VolumeRecord both({"Heart", "LV cavity"});
  both.add(0, {700, 120});
  writeVolumeTable(folder / "both.csv", both, {{"lv", 1}});
  EXPECT_EQ(tests::contentsOf(folder / "both.csv"), "time_s,Heart_ml,LV cavity_ml,lv_ml\n0,700,120,120\n");
  VolumeRecord one({"LV cavity"});
  one.add(0, {120});
  writeVolumeTable(folder / "one.csv", one, {{"lv", 0}});
  EXPECT_EQ(tests::contentsOf(folder / "one.csv"), "time_s,LV cavity_ml\n0,120\n");
}

TEST(VolumeTable, SaysWhenItCannotBeWritten) {
  EXPECT_THROW(writeVolumeTable("/nowhere/at/all.csv", VolumeRecord({"LV"})), CannotCreateError);
}

} // namespace
} // namespace viscera::sequences
