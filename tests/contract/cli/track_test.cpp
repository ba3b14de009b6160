#include <cmath>
#include <sstream>

#include "beating_labels.h"
#include "build_paths.h"
#include "cli_test.h"

namespace viscera::app::cli {
namespace {

const std::filesystem::path kCine = std::filesystem::path(VISCERA_SHARED_ORGANS) / "cine";

class Track : public CliTest {
protected:
  /// The volumes of a table of `viscera play`, by column.
  std::map<std::string, std::vector<double>> table(const std::string& file) const {
    std::istringstream lines(contents(file));
    std::string line, cell;
    std::vector<std::string> names;
    std::map<std::string, std::vector<double>> columns;
    for (bool first = true; std::getline(lines, line); first = false) {
      std::istringstream cells(line);
      for (std::size_t i = 0; std::getline(cells, cell, ','); ++i)
        if (first)
          names.push_back(cell.substr(0, cell.rfind("_ml")));
        else
          columns[names[i]].push_back(std::stod(cell));
    }
    return columns;
  }

  /// Six phases of a small heart in one file.
  std::string cine() const {
    std::vector<tests::LabelImage> phases;
    for (int phase = 0; phase < 6; ++phase)
      phases.push_back(tests::beatingLabels(phase / 6.0, Vec3(4, 4, 8)));
    return put("cine.nii", tests::nifti4d(phases, 150, 16));
  }
  /// The same heart as grey values over a cycle of eight phases, and labels of one phase.
  std::string greyCine() const {
    std::vector<tests::LabelImage> phases;
    for (int phase = 0; phase < 8; ++phase) {
      tests::LabelImage& image = phases.emplace_back(tests::beatingLabels(phase / 8.0, Vec3(2, 2, 8)));
      for (std::size_t v = 0; v < image.voxels.size(); ++v) {
        static constexpr int kGrey[] = {20, 100, 100, 50};
        image.voxels[v] = kGrey[image.voxels[v]] + int(v % 7);
      }
    }
    return put("grey.nii", tests::nifti4d(phases, 100, 16));
  }
  std::string labelsOf(int phase) const {
    return put("labels" + std::to_string(phase) + ".nii",
               tests::niftiFile(tests::beatingLabels(phase / 8.0, Vec3(2, 2, 8))));
  }
};

TEST_F(Track, KeepsItsContractAndIsPlayedAgainWithTheSameVolumes) {
  const json found = runJson({"track", cine(), "-o", path("m.sequence.json"), "--write-handles",
                              path("h.mrk.json"), "--write-organs", path("organs"), "--handles", "60",
                              "--surface", "LV=1", "--surface", "RV=2", "--surface", "EPI=1,2,3"});
  for (const std::string key :
       {"phases", "periodMs", "handles", "folded", "ejectionFraction", "seconds", "warnings"})
    EXPECT_TRUE(found.contains(key)) << key;
  EXPECT_NEAR(found["periodMs"].get<double>(), 900, 1e-3);
  EXPECT_EQ(found["handles"], 60);
  ASSERT_EQ(found["phases"].size(), 6U);
  for (const std::string key : {"timeMs", "meanMm", "p95Mm", "maxMm", "dice", "surfaces"})
    EXPECT_TRUE(found["phases"][0].contains(key)) << key;
  EXPECT_EQ(found["ejectionFraction"].size(), 4U) << "under the names of the files and of the scheme";
  EXPECT_EQ(found["ejectionFraction"]["lv"], found["ejectionFraction"]["LV"]);
  // Six frames a beat are its keys.
  const json played =
      runJson({"play", path("m.sequence.json"), "--fps", std::to_string(6 / 0.9), "--csv", path("v.csv")});
  EXPECT_NEAR(played["ejectionFraction"].get<double>(), found["ejectionFraction"]["LV"].get<double>(), 1e-4);
  EXPECT_EQ(played["volumes"]["lv"], played["volumes"]["LV"]);
  EXPECT_EQ(played["endDiastolicVolumeMl"], played["indices"]["lv"]["endDiastolicVolumeMl"]);
  EXPECT_NEAR(played["indices"]["RV"]["ejectionFraction"].get<double>(),
              found["ejectionFraction"]["RV"].get<double>(), 1e-4);
  const auto volumes = table(path("v.csv"));
  for (const std::string name : {"LV", "RV", "EPI"})
    for (std::size_t phase = 0; phase < 6; ++phase) {
      const double measured = found["phases"][phase]["surfaces"][name]["volumeMl"];
      EXPECT_NEAR(volumes.at(name).at(phase) / measured, 1, 1e-4) << name << ", phase " << phase;
    }
  // By its surfaces one by one too, at a rate of frames that meets no key.
  const json alone =
      runJson({"play", path("m.sequence.json"), "--organ", path("organs/RV.obj"), "--fps", "7"});
  EXPECT_NEAR(alone["ejectionFraction"].get<double>(), found["ejectionFraction"]["RV"].get<double>(), 1e-4);
  EXPECT_GT(alone["strokeVolumeMl"].get<double>(), 1);
  EXPECT_GT(alone["cardiacOutputLPerMinute"].get<double>(), 0);
  EXPECT_TRUE(std::filesystem::exists(path("h.mrk.json")));
}

TEST_F(Track, LetsOneImageOfAHeartBeatAsTheTextbooks) {
  const std::string image =
      put("heart.seg.nrrd", tests::nrrdFile(tests::beatingLabels(0, Vec3(4, 4, 4)), "right-anterior-superior",
                                            tests::kHeartKeys));
  const json found = runJson({"track", image, "--textbook", "--ejection-fraction", "0.25", "--rate", "60",
                              "-o", path("t.sequence.json")});
  EXPECT_NEAR(found["ejectionFraction"]["LV"].get<double>(), 0.25, 0.02);
  EXPECT_NEAR(found["indices"]["RV"]["strokeVolumeMl"].get<double>() /
                  found["indices"]["LV"]["strokeVolumeMl"].get<double>(),
              1, 0.03);
  EXPECT_EQ(found["ejectionFraction"]["lv"], found["ejectionFraction"]["LV"]);
  EXPECT_EQ(found["indices"]["rv"], found["indices"]["RV"]);
  for (const char* key : {"endDiastolicVolumeMl", "endSystolicVolumeMl", "strokeVolumeMl", "ejectionFraction",
                          "cardiacOutputLPerMinute", "endDiastolicMl", "endSystolicMl"})
    EXPECT_TRUE(found["indices"]["lv"][key].is_number()) << key;
  EXPECT_NEAR(found["periodMs"].get<double>(), 1000, 1e-6);
  const json played = runJson({"play", path("t.sequence.json"), "--fps", "25", "--csv", path("v.csv")});
  EXPECT_NEAR(played["ejectionFraction"].get<double>(), found["ejectionFraction"]["LV"].get<double>(), 1e-4);
  expectFailure({"track", image, "-o", path("n.sequence.json")}, kBadData, "--textbook");
}

TEST_F(Track, SaysWhatIsMissingAndLeavesNothing) {
  const std::string file = cine();
  const auto before = files();
  expectFailure({"track", file, "-o", path("m.sequence.json")}, kUsage, "say which surfaces they make");
  expectFailure({"track", file, "-o", path("m.json"), "--surface", "LV=1"}, kUsage, "end in .sequence.json");
  expectFailure({"track", file, "-o", path("m.sequence.json"), "--surface", "LV"}, kUsage,
                "a name and labels");
  expectFailure({"track", file, "-o", path("m.sequence.json"), "--surface", "LV=9"}, kUsage, "9");
  expectFailure({"track", path("nobody"), "-o", path("m.sequence.json")}, kNoInput, "no such file or folder");
  EXPECT_EQ(files(), before);
}

TEST_F(Track, FindsTheMotionBetweenTwoLabelledPhasesFromImages) {
  const std::string images = greyCine(), diastole = labelsOf(0), systole = labelsOf(4);
  const json found =
      runJson({"track", "--images", images, "--phase", "4=" + systole, "--phase", "0=" + diastole, "-o",
               path("c.sequence.json"), "--handles", "60", "--surface", "LV=1", "--surface", "EPI=1,2,3"});
  ASSERT_EQ(found["phases"].size(), 8U);
  EXPECT_NEAR(found["periodMs"].get<double>(), 800, 1e-3);
  EXPECT_EQ(found["labelledPhases"], json({0, 4}));
  EXPECT_EQ(found["estimate"], false);
  EXPECT_EQ(found["endDiastolePhase"], 0);
  EXPECT_EQ(found["endSystolePhase"], 4);
  for (std::size_t phase = 0; phase < 8; ++phase) {
    EXPECT_EQ(found["phases"][phase]["labelled"], phase == 0 || phase == 4);
    const double volume = found["phases"][phase]["surfaces"]["LV"]["fittedMl"];
    EXPECT_LE(volume, found["phases"][0]["surfaces"]["LV"]["volumeMl"].get<double>() + 1e-4);
    EXPECT_GE(volume, found["phases"][4]["surfaces"]["LV"]["volumeMl"].get<double>() - 1e-4);
  }
  const double full = found["phases"][0]["surfaces"]["LV"]["volumeMl"],
               empty = found["phases"][4]["surfaces"]["LV"]["volumeMl"];
  EXPECT_NEAR(found["ejectionFraction"]["lv"].get<double>(), (full - empty) / full, 1e-6);
  ASSERT_GE(found["planes"].size(), 5U);
  for (const std::string key : {"name", "series", "plane", "longAxis", "weight", "likeness", "closureMm",
                                "apartMm", "light", "reason"})
    EXPECT_TRUE(found["planes"][0].contains(key)) << key;
  EXPECT_EQ(found["planes"][0]["phases"][0]["state"], "labelled");
  EXPECT_EQ(found["planes"][0]["phases"].size(), 8U);
  EXPECT_TRUE(found["findings"].is_array());
  const json played = runJson({"play", path("c.sequence.json"), "--fps", "10"});
  EXPECT_NEAR(played["ejectionFraction"].get<double>(), found["ejectionFraction"]["LV"].get<double>(), 1e-4);
}

TEST_F(Track, MeetsACorrectedContourOrSaysWhatIsWrongWithIt) {
  const std::string images = greyCine(), diastole = labelsOf(0), systole = labelsOf(4);
  const auto track = [&](const std::string& correction, const std::string& out) {
    return std::vector<std::string>{"track",     "--images",     images, "--phase",   "0=" + diastole,
                                    "--phase",   "4=" + systole, "-o",   path(out),   "--handles",
                                    "60",        "--surface",    "LV=1", "--surface", "EPI=1,2,3",
                                    "--correct", correction};
  };
  const auto corrections = [&](const std::string& item) {
    return put("c.json", "{\"corrections\": [" + item + "]}");
  };
  const auto before = files();
  expectFailure(track(path("none.json"), "n.sequence.json"), kNoInput, "none.json");
  expectFailure(track(put("c.json", "{}"), "n.sequence.json"), kBadData, "corrections");
  expectFailure(track(corrections(R"({"phase": 2})"), "n.sequence.json"), kBadData, "pointsMm");
  expectFailure(
      track(corrections(R"({"phase": 4, "surface": "LV", "pointsMm": [[0, 0, 0]]})"), "n.sequence.json"),
      kUsage, "Phase 4 has labels");
  expectFailure(
      track(corrections(R"({"phase": 9, "surface": "LV", "pointsMm": [[0, 0, 0]]})"), "n.sequence.json"),
      kUsage, "no phase 9");
  expectFailure(
      track(corrections(R"({"phase": 2, "surface": "RA", "pointsMm": [[0, 0, 0]]})"), "n.sequence.json"),
      kUsage, "use one of");
  expectFailure(track(corrections(R"({"phase": 2, "surface": "LV", "pointsMm": [[900, 900, 900]]})"),
                      "n.sequence.json"),
                kUsage, "beside the plane");
  expectFailure({"track", diastole, "-o", path("n.sequence.json"), "--correct", corrections("")}, kUsage,
                "There are no images");
  std::filesystem::remove(path("c.json"));
  EXPECT_EQ(files(), before);
  // The cavity's wall 2 mm farther out than it is in the images, in the slice at 0 mm.
  const json found = runJson(
      track(corrections(R"({"phase": 2, "surface": "LV", "pointsMm": [[-11, 17, 0]]})"), "c.sequence.json"));
  ASSERT_EQ(found["corrections"].size(), 1U);
  const json& met = found["corrections"][0];
  for (const std::string key : {"phase", "slice", "series", "surface", "beforeMm", "mostMm", "met"})
    EXPECT_TRUE(met.contains(key)) << key;
  EXPECT_EQ(met["slice"], 5);
  EXPECT_GT(met["beforeMm"].get<double>(), 0.5);
  EXPECT_LE(met["mostMm"].get<double>(), 0.3);
  EXPECT_EQ(met["met"], true);
  for (const std::size_t phase : {0U, 4U}) {
    const json& cavity = found["phases"][phase]["surfaces"]["LV"];
    EXPECT_NEAR(cavity["fittedMl"].get<double>(), cavity["volumeMl"].get<double>(), 1e-5);
  }
}

TEST_F(Track, FromOneLabelledPhaseGivesEstimatesThatSaySo) {
  const json found =
      runJson({"track", "--images", greyCine(), "--phase", "0=" + labelsOf(0), "-o", path("e.sequence.json"),
               "--handles", "60", "--surface", "LV=1", "--surface", "RV=2", "--surface", "EPI=1,2,3"});
  EXPECT_EQ(found["estimate"], true);
  EXPECT_EQ(found["phases"][0]["surfaces"]["LV"]["estimate"], false);
  EXPECT_EQ(found["phases"][3]["surfaces"]["LV"]["estimate"], true);
  EXPECT_TRUE(found["phases"][3]["surfaces"]["RV"]["fittedMl"].is_null());
  EXPECT_EQ(found["indices"]["lv"]["estimate"], true);
  EXPECT_FALSE(found["indices"].contains("rv"));
  EXPECT_NE(found["findings"].dump().find("estimates"), std::string::npos);
}

TEST_F(Track, SaysWhatIsWrongWithImagesAndTheirLabels) {
  const std::string images = greyCine(), diastole = labelsOf(0), out = path("w.sequence.json");
  const auto before = files();
  const auto refuse = [&](std::vector<std::string> arguments, int code, const std::string& words) {
    arguments.insert(arguments.begin(), "track");
    arguments.insert(arguments.end(), {"-o", out});
    expectFailure(arguments, code, words);
  };
  refuse({"--images", images}, kUsage, "No phase has labels");
  refuse({"--images", images, "--phase", "8=" + diastole, "--surface", "LV=1"}, kUsage, "no phase 8");
  refuse({"--images", images, "--phase", diastole}, kUsage, "as in --phase 9=es.nrrd");
  refuse({"--images", images, "--phase", "0=" + path("none.nrrd")}, kNoInput, "no such file");
  refuse({"--images", images, "--phase", "0=" + diastole}, kUsage, "say which surfaces they make");
  refuse({"--phase", "0=" + diastole}, kUsage, "There are no images");
  refuse({diastole, "--images", images}, kUsage, "Images have no use for it");
  refuse({}, kUsage, "There is no series");
  EXPECT_EQ(files(), before);
}

TEST_F(Track, HoldsARealRightVentricle) {
  if (!std::filesystem::exists(kCine))
    GTEST_SKIP() << "shared/organs/cine is absent";
  const json found = runJson({"track", kCine.string(), "-o", path("rv.sequence.json"), "--period-ms", "829"});
  ASSERT_EQ(found["phases"].size(), 25U);
  EXPECT_EQ(found["handles"], 60);
  const std::string name = "patient1_RV_ENDOCARDIAL";
  EXPECT_NEAR(found["ejectionFraction"][name].get<double>(), 0.549, 0.001);
  double mean = 0;
  for (const json& phase : found["phases"]) {
    mean += phase["meanMm"].get<double>() / 25;
    EXPECT_NEAR(phase["surfaces"][name]["fittedMl"].get<double>() /
                    phase["surfaces"][name]["volumeMl"].get<double>(),
                1, 1e-6);
    EXPECT_EQ(phase["surfaces"][name]["flipped"], 0);
  }
  EXPECT_LT(mean, 0.7);
  const json played = runJson(
      {"play", path("rv.sequence.json"), "--fps", std::to_string(25 / 0.829), "--csv", path("v.csv")});
  EXPECT_NEAR(played["ejectionFraction"].get<double>(), 0.549, 0.001);
  const auto volumes = table(path("v.csv")).at(name);
  for (std::size_t phase = 0; phase < 25; ++phase)
    EXPECT_NEAR(volumes.at(phase) / found["phases"][phase]["surfaces"][name]["volumeMl"].get<double>(), 1,
                1e-4)
        << "phase " << phase;
}

} // namespace
} // namespace viscera::app::cli
