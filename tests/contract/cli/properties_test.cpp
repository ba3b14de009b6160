#include <set>

#include "cli_test.h"

namespace viscera::app::cli {

using CliProperties = CliTest;

TEST_F(CliProperties, MeasureTheSystemsAskedFor) {
  const std::string file = path("p.csv");
  const json result = runJson({"properties", "--systems", "s-celestial", "determinants-approach",
                               "wire-approach", "--points", "20", "-o", file});
  const json& rows = result["rows"];
  ASSERT_EQ(rows.size(), 3u);
  for (const json& row : rows) {
    for (const char* key : {"identityError", "unityError", "minWeight", "largestKink", "rotationChange",
                            "handleError", "nsPerVertexHandle", "failures", "refusals", "points"})
      EXPECT_TRUE(row[key].is_number()) << key;
    EXPECT_TRUE(row["failureReasons"].is_array());
    EXPECT_EQ(row["scenes"].size(), 8u);
  }
  EXPECT_EQ(rows[0]["system"], "s-celestial");
  EXPECT_EQ(rows[0]["largestJump"], 0.0);
  EXPECT_EQ(rows[0]["kinks"], 0);
  EXPECT_EQ(rows[0]["failures"], 0);
  EXPECT_EQ(rows[0]["rotationInvariant"], true);
  EXPECT_EQ(rows[0]["interpolates"], true);
  EXPECT_GT(rows[0]["minWeight"].get<double>(), 0);
  EXPECT_GT(rows[1]["largestJump"].get<double>(), 1e-3);
  EXPECT_TRUE(rows[1]["kinks"].is_null());
  EXPECT_GT(rows[2]["failures"].get<int>(), 100);
  EXPECT_FALSE(rows[2]["failureReasons"].empty());

  const std::string table = contents(file);
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 3 * 8);
  EXPECT_EQ(table.rfind("system,scene,handles,points,", 0), 0u);
  EXPECT_EQ(files(), 1);
}

TEST_F(CliProperties, KnowPluginsAndTheirGroups) {
  const json row = runJson({"properties", "--systems", "localised-s-celestial", "--points", "20"})["rows"][0];
  EXPECT_EQ(row["system"], "localised-s-celestial");
  EXPECT_EQ(row["refusals"], 0);
  const json& organ = row["scenes"].back();
  EXPECT_EQ(organ["failures"], 0);
  EXPECT_EQ(organ["minWeight"], 0.0) << "handles of other groups have none";
}

TEST_F(CliProperties, TakeParametersForTheSystemsThatKnowThem) {
  const json rows = runJson({"properties", "--systems", "s-celestial", "mean-value", "--points", "20",
                             "--param", "softness=5"})["rows"];
  EXPECT_EQ(rows[0]["interpolates"], false);
  expectFailure({"properties", "--systems", "mean-value", "--param", "softness=5"}, kUsage, "softness");
  expectFailure({"properties", "--systems", "s-celestial", "--param", "softness"}, kUsage, "NAME=VALUE");
  expectFailure({"properties", "--systems", "nosuch"}, kUsage, "s-celestial");
  expectFailure({"properties", "--points", "0"}, kUsage, "--points");
}

TEST_F(CliProperties, PrintATableForAReader) {
  const test::ProcessResult result = run({"properties", "--systems", "wire-approach", "--points", "20"});
  EXPECT_EQ(result.exitCode, kOk);
  EXPECT_NE(result.out.find("identity"), std::string::npos);
  EXPECT_NE(result.out.find("line, 15 handles: no coordinates at"), std::string::npos) << result.out;
}

TEST_F(CliProperties, WriteNothingWhenInterrupted) {
  options_.interruptAfter = std::chrono::milliseconds(1500);
  const test::ProcessResult result = run({"properties", "--points", "20000", "-o", path("p.csv")});
  EXPECT_EQ(result.exitCode, kCancelled);
  EXPECT_EQ(files(), 0);
}

} // namespace viscera::app::cli
