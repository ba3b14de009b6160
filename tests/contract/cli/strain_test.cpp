#include <fstream>

#include <gmock/gmock.h>

#include "cli_test.h"

namespace viscera::app::cli {

/// `viscera strain`: the keys of the contract, and the sample heart's own beat against what was measured
/// another way.
class CliStrain : public CliTest {};

TEST_F(CliStrain, OfTheTextbookBeatAgreesWithWhatTheWallGaugeMeasures) {
  const std::string csv = path("strain.csv"), png = path("strain.png");
  const json found = runJson({"strain", "heartbeat", "--instants", "24", "--witnesses", "6000", "--csv", csv,
                              "--png", png, "--size", "900x700"});
  for (const char* key : {"definition", "gls", "gcs", "grs", "rvFreeWall", "segments", "phases", "axes"})
    EXPECT_TRUE(found.contains(key)) << key;
  EXPECT_EQ(found["surfaces"]["lv"], "lv");
  EXPECT_EQ(found["segments"].size(), 17U);
  EXPECT_EQ(found["phases"].size(), 24U);
  // docs/reference_values.md: 9.44 degrees between rings that lie a little further apart.
  EXPECT_NEAR(found["twistDegrees"].get<double>(), 9.44, 2);
  // A healthy beat: shorter along and around, thicker.
  EXPECT_LT(found["gls"]["peakPercent"].get<double>(), -10);
  EXPECT_GT(found["gls"]["peakPercent"].get<double>(), -30);
  EXPECT_LT(found["gcs"]["peakPercent"].get<double>(), -12);
  EXPECT_GT(found["grs"]["peakPercent"].get<double>(), 15);
  for (const char* level : {"base", "middle", "apex"})
    EXPECT_LT(found["gcs"][level]["peakPercent"].get<double>(), -5) << level;
  std::ifstream table(csv);
  std::string line;
  int rows = 0;
  while (std::getline(table, line))
    ++rows;
  EXPECT_EQ(rows, 25);
  EXPECT_GT(std::ifstream(png, std::ios::ate).tellg(), 10000);
}

TEST_F(CliStrain, SaysWhatItLacks) {
  expectFailure({"strain", "liver.sequence.json"}, kNoInput, "liver.sequence.json");
  expectFailure({"strain", "heartbeat", "--reference", "900", "--instants", "8", "--witnesses", "2000"},
                kBadData, "phase 900");
  expectFailure({"strain", "heartbeat", "--lv", "ventricle", "--instants", "4"}, kUsage, "lv");
  expectFailure({"strain", "heartbeat", "--apex", "1,2"}, kUsage, "--apex");
}

} // namespace viscera::app::cli
