#include <algorithm>
#include <sstream>

#include <gmock/gmock.h>

#include "cli_test.h"

namespace viscera::app::cli {

/// `viscera circulate`: the keys and columns of the contract, and that they say what is so.
class CliCirculate : public CliTest {
protected:
  static void expectChamber(const json& object, const std::string& name) {
    for (const char* key : {"edpMmHg", "dpdtMax", "strokeWorkJ"})
      EXPECT_TRUE(object[name][key].is_number()) << name << " " << key;
    const std::pair<const char*, const char*> names[] = {{"endDiastolicVolumeMl", "edvMl"},
                                                         {"endSystolicVolumeMl", "esvMl"},
                                                         {"strokeVolumeMl", "svMl"},
                                                         {"ejectionFraction", "ef"}};
    for (const auto& [key, older] : names) {
      EXPECT_TRUE(object[name][key].is_number()) << name << " " << key;
      EXPECT_EQ(object[name][key], object[name][older]) << name << " " << key;
    }
  }
};

TEST_F(CliCirculate, RestHasTheKeysOfTheContract) {
  const json rest = runJson({"circulate"});
  EXPECT_EQ(rest["scenario"], "rest");
  EXPECT_EQ(rest["converged"], true);
  EXPECT_EQ(rest["ratePerMinute"], 72.0);
  EXPECT_TRUE(rest["beats"].is_number_integer());
  EXPECT_TRUE(rest["parameters"].empty());
  for (const char* chamber : {"lv", "rv", "la", "ra"})
    expectChamber(rest, chamber);
  for (const char* artery : {"aorta", "pulmonaryArtery"})
    for (const char* key : {"systolic", "diastolic", "mean"})
      EXPECT_TRUE(rest[artery][key].is_number()) << artery << " " << key;
  EXPECT_NEAR(rest["aorta"]["systolic"].get<double>(), 120, 5);
  EXPECT_NEAR(rest["cardiacOutputLPerMinute"].get<double>(), 5.5, 0.5);
  EXPECT_EQ(rest["cardiacOutputLPerMinute"], rest["cardiacOutputLMin"]);
  EXPECT_NEAR(rest["ejectionMs"].get<double>(), 1000 * rest["ejectionSeconds"].get<double>(), 1e-9);
  EXPECT_NEAR(rest["relaxationMs"].get<double>(), 1000 * rest["relaxationSeconds"].get<double>(), 1e-9);
  EXPECT_LT(rest["volumeErrorMl"].get<double>(), 1e-9);
  EXPECT_TRUE(rest["seconds"].is_number());
}

TEST_F(CliCirculate, ScenarioAndParametersAreBothApplied) {
  const json ill = runJson(
      {"circulate", "--scenario", "aortic-stenosis", "--param", "aorticArea=0.6", "--param", "rate=60"});
  EXPECT_EQ(ill["parameters"]["aorticArea"], 0.6);
  EXPECT_EQ(ill["ratePerMinute"], 60.0);
  EXPECT_TRUE(ill["parameters"].contains("lvEes"));
  const json milder = runJson({"circulate", "--scenario", "aortic-stenosis", "--param", "rate=60"});
  EXPECT_GT(ill["aorticMeanGradientMmHg"].get<double>(), milder["aorticMeanGradientMmHg"].get<double>() + 10);
}

TEST_F(CliCirculate, TableHasAColumnForEveryCurveAndClosesTheCycle) {
  const std::string file = path("beat.csv");
  runJson({"circulate", "--scenario", "exercise", "--csv", file});
  std::istringstream table(contents(file));
  std::string header, line, first, last;
  std::getline(table, header);
  int rows = 0;
  for (; std::getline(table, line); last = line)
    if (rows++ == 0)
      first = line;
  EXPECT_EQ(rows, 1001);
  EXPECT_EQ(header.rfind("time_s,lv_mmHg,", 0), 0u);
  for (const char* column :
       {"la_mmHg", "aorta_mmHg", "pulmonary_artery_mmHg", "rv_ml", "mitral_ml_s", "aortic_open", "ecg_mV"})
    EXPECT_THAT(header, testing::HasSubstr(column));
  EXPECT_EQ(std::count(header.begin(), header.end(), ','), std::count(first.begin(), first.end(), ','));
  EXPECT_EQ(first.rfind("0,", 0), 0u) << first;
  EXPECT_EQ(last.rfind("0.4,", 0), 0u) << last; // 150 beats a minute.
  EXPECT_EQ(files(), 1);
}

TEST_F(CliCirculate, PictureIsDrawnInTheSizeAskedFor) {
  const std::string file = path("loops.png");
  const json result = runJson({"circulate", "--scenario", "tamponade", "--png", file, "--size", "640x400"});
  EXPECT_EQ(result["png"], file);
  const std::string picture = contents(file);
  ASSERT_GT(picture.size(), 5000u);
  EXPECT_EQ(picture.substr(1, 3), "PNG");
  const auto byte = [&](std::size_t place) { return static_cast<unsigned char>(picture[place]); };
  EXPECT_EQ(256 * byte(18) + byte(19), 640);
  EXPECT_EQ(256 * byte(22) + byte(23), 400);
}

TEST_F(CliCirculate, OneParameterIsVariedOverItsRange) {
  const json result = runJson({"circulate", "--vary", "stressedVolume=700:1300"});
  const json& rows = result["rows"];
  ASSERT_EQ(rows.size(), 13u);
  EXPECT_EQ(rows.front()["value"], 700.0);
  EXPECT_EQ(rows.back()["value"], 1300.0);
  EXPECT_GT(rows.back()["lv"]["svMl"].get<double>(), rows.front()["lv"]["svMl"].get<double>());
}

TEST_F(CliCirculate, ListsScenariosParametersAndPublishedValues) {
  const json list = runJson({"circulate", "--list"});
  EXPECT_EQ(list["scenarios"].size(), 9u);
  for (const json& parameter : list["parameters"])
    EXPECT_LT(parameter["lowest"].get<double>(), parameter["highest"].get<double>());
  const json published = runJson({"circulate", "--published"});
  EXPECT_GT(published["rows"].size(), 20u);
  for (const json& row : published["rows"])
    EXPECT_THAT(row["source"].get<std::string>(), testing::ContainsRegex("doi 10\\.|[0-9]+:[0-9]+-[0-9]+"));
}

TEST_F(CliCirculate, TheSampleHeartFollowsAScenario) {
  const std::vector<std::string> play = {"play", "heartbeat", "--organ", "sample:heart@low", "--fps", "50"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), play.begin(), play.end());
    return more;
  };
  const json wanted = runJson({"circulate", "--scenario", "heart-failure-reduced-ef"});
  const json played = runJson(with({"--scenario", "heart-failure-reduced-ef"}));
  EXPECT_EQ(played["scenario"], "heart-failure-reduced-ef");
  EXPECT_EQ(played["ratePerMinute"], wanted["ratePerMinute"]);
  EXPECT_NEAR(played["ejectionFraction"].get<double>(), wanted["lv"]["ef"].get<double>(), 0.01);
  EXPECT_NEAR(played["volumes"]["lv"]["maxMl"].get<double>(), wanted["lv"]["edvMl"].get<double>(), 1);
  EXPECT_NEAR(played["volumes"]["rv"]["maxMl"].get<double>(), wanted["rv"]["edvMl"].get<double>(), 1);
  EXPECT_EQ(runJson(with({"--scenario", "rest", "--rate", "90"}))["ratePerMinute"], 90.0);
  expectFailure({"play", "breathing", "--scenario", "rest"}, kUsage, "sample heart");
  expectFailure(with({"--scenario", "sleep"}), kUsage, "exercise");
}

TEST_F(CliCirculate, FindsTheCirculationOfAPatientsVentricleAndSaysWhatItReached) {
  const json found = runJson({"circulate", "--edv", "190", "--ef", "0.4", "--rate", "80"});
  EXPECT_TRUE(found["fit"]["met"]);
  EXPECT_NEAR(found["lv"]["edvMl"].get<double>(), 190, 0.5);
  EXPECT_NEAR(found["lv"]["ef"].get<double>(), 0.4, 0.002);
  EXPECT_EQ(found["ratePerMinute"], 80.0);
  EXPECT_TRUE(found["parameters"].contains("lvEes"));
  expectFailure({"circulate", "--edv", "190"}, kUsage, "ejection fraction");
  expectFailure({"circulate", "--edv", "190", "--ef", "40"}, kUsage, "0.55");
  expectFailure({"circulate", "--rate", "80"}, kUsage, "--param rate");
  expectFailure({"circulate", "--edv", "190", "--ef", "0.4", "--param", "lvEes=2"}, kUsage, "fit");
}

TEST_F(CliCirculate, MistakesAreNamed) {
  expectFailure({"circulate", "--scenario", "sleep"}, kUsage, "heart-failure-reduced-ef");
  expectFailure({"circulate", "--param", "lvEse=2"}, kUsage, "lvEes");
  expectFailure({"circulate", "--param", "rate=500"}, kUsage, "30 to 200");
  expectFailure({"circulate", "--param", "rate"}, kUsage, "=");
  expectFailure({"circulate", "--param", "rate=fast"}, kUsage, "number");
  expectFailure({"circulate", "--vary", "rate=60"}, kUsage, "range");
  expectFailure({"circulate", "--vary", "rate=60:80", "--csv", "x.csv"}, kUsage, "--vary");
  expectFailure({"circulate", "--csv", path("no/such/folder.csv")}, kCannotCreate, "folder");
}

} // namespace viscera::app::cli
