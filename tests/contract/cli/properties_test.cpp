#include <set>

#include "cli_test.h"
#include "promises.h"

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

/// Systems that take seconds are left out.
TEST_F(CliProperties, DoNotContradictWhatTheSystemsPromise) {
  const std::set<std::string> slow = {"c-celestial", "harmonic", "bounded-biharmonic",
                                      "numerical-integration", "voronoi-regions"};
  auto table = tests::promises();
  std::vector<std::string> arguments = {"properties", "--points", "20", "--systems"};
  for (const auto& [id, row] : table)
    if (!slow.count(id))
      arguments.push_back(id);
  const json rows = runJson(arguments)["rows"];
  ASSERT_EQ(rows.size(), 21u - slow.size());
  for (const json& row : rows) {
    const std::string id = row["system"];
    auto& promised = table.at(id);
    EXPECT_EQ(row["refusals"], 0) << id;
    const auto holds = [&](const char* promise, bool measured) {
      EXPECT_TRUE(!promised.at(promise) || measured) << id << " is not " << promise << ": " << row.dump();
    };
    holds("positive", row["minWeight"] >= 0);
    holds("everywhere", row["failures"] == 0);
    holds("continuous", row["largestJump"] == 0);
    holds("smooth", row["kinks"] == 0);
    // The corners of the box around the organ are equally far from many points: rounding decides among them.
    const double turned = id == "incremental-approach" ? 0.01 : 0;
    holds("rotationInvariant", row["rotationInvariant"] == true || row["rotationChange"] < turned);
    // A handle that is no corner of the cage has no influence.
    holds("interpolates", promised.at("needsCage") || row["interpolates"] == true);
  }
}

TEST_F(CliProperties, OffersForRegionsTheSystemsThatSuitThem) {
  std::set<std::string> promised, offered;
  for (const auto& [id, row] : tests::promises())
    if (row.at("localisable"))
      promised.insert(id);
  const json listing = runJson({"systems"});
  for (const json& system : listing["systems"])
    for (const json& parameter : system["parameters"])
      if (system["id"] == "localised-s-celestial" && parameter["name"] == "inner")
        offered = std::set<std::string>(parameter["choices"].begin(), parameter["choices"].end());
  EXPECT_EQ(offered, promised);
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

TEST_F(CliProperties, CompareSystemsWithAnElasticOrgan) {
  const std::string table = path("drags.csv"), figure = path("drags.svg");
  const json result =
      runJson({"properties", "--elasticity", "--systems", "s-celestial", "wire-approach", "--organs",
               "kidney_left", "--drags", "1", "--tetrahedra", "150", "-o", table, "--figure", figure});
  ASSERT_EQ(result["organs"].size(), 1U);
  EXPECT_EQ(result["organs"][0]["solved"], 1);
  EXPECT_GT(result["organs"][0]["drags"][0]["dragMm"], 0);
  ASSERT_EQ(result["rows"].size(), 2U);
  const json& row = result["rows"][0];
  for (const char* key :
       {"medianPercentOfDrag", "p95PercentOfDrag", "percentOfElastic", "spearman", "bindSeconds", "poseMs"})
    EXPECT_TRUE(row[key].is_number()) << key;
  EXPECT_LE(row["medianPercentOfDrag"], row["p95PercentOfDrag"]);
  EXPECT_TRUE(result["rows"][1]["spearman"].is_null());
  EXPECT_NE(result["rows"][1]["organs"][0]["refusal"].get<std::string>().find("have no coordinates"),
            std::string::npos);
  const std::string rows = contents(table);
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 3);
  EXPECT_NE(contents(figure).find("S-Celestial"), std::string::npos);
  expectFailure({"properties", "--drags", "1"}, kUsage, "--elasticity");
}

TEST_F(CliProperties, WriteNothingWhenInterrupted) {
  options_.interruptAfter = std::chrono::milliseconds(1500);
  const test::ProcessResult result = run({"properties", "--points", "20000", "-o", path("p.csv")});
  EXPECT_EQ(result.exitCode, kCancelled);
  EXPECT_EQ(files(), 0);
}

} // namespace viscera::app::cli
