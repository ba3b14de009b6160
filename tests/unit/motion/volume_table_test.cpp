#include "viscera/motion/volume_record.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "viscera/core/error.h"

namespace viscera::motion {
namespace {

TEST(VolumeTable, HasOneColumnAnOrganAndOneRowAnInstant) {
  VolumeRecord record({"LV", "Heart, \"left\""});
  record.add(0, {130.5, 938.25});
  record.add(0.04, {129, 937});
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "viscera_volume_table.csv";
  writeVolumeTable(file, record);
  std::ifstream stream(file);
  const std::string contents{std::istreambuf_iterator<char>(stream), {}};
  std::filesystem::remove(file);
  EXPECT_EQ(contents, "time_s,LV_ml,\"Heart, \"\"left\"\"_ml\"\n"
                      "0,130.5,938.25\n"
                      "0.04,129,937\n");
}

TEST(VolumeTable, SaysWhenItCannotBeWritten) {
  EXPECT_THROW(writeVolumeTable("/nowhere/at/all.csv", VolumeRecord({"LV"})), CannotCreateError);
}

} // namespace
} // namespace viscera::motion
