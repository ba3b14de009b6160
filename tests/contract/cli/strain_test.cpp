#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <utility>

#include <gmock/gmock.h>

#include "build_paths.h"
#include "cli_test.h"
#include "held_value.h"

namespace viscera::app::cli {

/// `viscera strain`: the keys of the contract, and the sample heart's own beat against what was measured
/// another way.
class CliStrain : public CliTest {
protected:
  /// A surface with its points in the reverse order: the same place, without known points.
  static std::string reversed(const std::string& obj) {
    std::vector<std::string> points;
    std::string faces, line;
    std::istringstream lines(obj);
    while (std::getline(lines, line)) {
      if (line.starts_with("v "))
        points.push_back(line);
      if (line.starts_with("f "))
        faces += line + '\n';
    }
    std::string text;
    for (auto point = points.rbegin(); point != points.rend(); ++point)
      text += *point + '\n';
    std::istringstream rows(faces);
    while (std::getline(rows, line)) {
      std::istringstream corners(line.substr(2));
      text += 'f';
      for (std::string corner; corners >> corner;)
        text += ' ' + std::to_string(points.size() + 1 - std::stoul(corner));
      text += '\n';
    }
    return text;
  }

  /// What the tutor's guide says of a state of the circulation: a row of its table.
  std::string lessonRow(const std::string& name, const std::string& scenario) {
    const json strain =
        runJson({"strain", "heartbeat", "--scenario", scenario, "--instants", "24", "--witnesses", "2000"});
    const json beat = runJson({"circulate", "--scenario", scenario});
    std::ostringstream row;
    row << std::fixed << std::setprecision(0) << "| " << name << " | "
        << 100 * beat["lv"]["ejectionFraction"].get<double>() << " % | " << std::setprecision(1)
        << strain["gls"]["peakPercent"].get<double>() << " % | " << strain["gcs"]["peakPercent"].get<double>()
        << " % |\n";
    return row.str();
  }
};

/// The lesson "what the ejection fraction does not show". VISCERA_UPDATE_PAGES=1 writes its table.
TEST_F(CliStrain, MakesTheNumbersOfTheTutorsLesson) {
  const std::string file = VISCERA_SOURCE_DIR "/docs/tutor_guide.md";
  const std::string head = "| state | ejection fraction | GLS | GCS |\n|---|---|---|---|\n";
  const std::string table = head + lessonRow("rest", "rest") +
                            lessonRow("heart failure, preserved EF", "heart-failure-preserved-ef");
  std::string page = contents(file);
  if (std::getenv("VISCERA_UPDATE_PAGES")) {
    const std::size_t begin = page.find(head), end = page.find("\n\n", begin);
    page.replace(begin, end - begin + 1, table);
    std::ofstream(file, std::ios::binary) << page;
  }
  EXPECT_NE(page.find(table), std::string::npos) << "docs/tutor_guide.md should say:\n" << table;
}

/// The right ventricle of a person, measured like a left one: with its own points followed, and without.
/// The free wall moves along itself most: distances do not see it, the rims of its valves do.
TEST_F(CliStrain, OfARealVentricleIsTheSameToThreePointsWithoutCorrespondence) {
  const std::filesystem::path cine = std::filesystem::path(VISCERA_SHARED_ORGANS) / "cine";
  if (!std::filesystem::exists(cine))
    GTEST_SKIP() << "shared/organs/cine is absent";
  for (const char* folder : {"followed", "fitted"})
    std::filesystem::create_directories(path(folder));
  bool turn = false;
  for (const char* phase : {"00", "03", "06", "09", "12", "16", "20"}) {
    const std::string obj =
        contents((cine / ("patient1_RV_ENDOCARDIAL_0" + std::string(phase) + ".obj")).string());
    put("followed/rv_" + std::string(phase) + ".obj", obj);
    put("fitted/rv_" + std::string(phase) + ".obj", turn ? reversed(obj) : obj);
    turn = !turn;
  }
  const auto measured = [this](const char* folder) {
    return runJson({"strain", path(folder), "--period-ms", "829", "--once", "--lv", "rv"});
  };
  const json followed = measured("followed"), fitted = measured("fitted");
  EXPECT_EQ(followed["definition"]["correspondence"], true);
  EXPECT_EQ(fitted["definition"]["correspondence"], false);
  tests::HeldValue alongAndAround("a person's right ventricle without correspondence, along and around", 3,
                                  "points"),
      freeWall("free wall of that ventricle without correspondence", 3, "points");
  for (const auto& [key, held] : {std::pair("gls", &alongAndAround), std::pair("gcs", &alongAndAround),
                                  std::pair("rvFreeWall", &freeWall)}) {
    const double with = followed[key]["peakPercent"].get<double>();
    EXPECT_LT(with, -10) << key;
    held->add(fitted[key]["peakPercent"].get<double>() - with);
  }
  for (const char* contour : {"fourChamber", "twoChamber", "threeChamber"})
    EXPECT_NEAR(fitted["gls"][contour]["referenceMm"].get<double>() /
                    followed["gls"][contour]["referenceMm"].get<double>(),
                1, 0.01)
        << contour << ": at rest both are the same surface";
  for (const json& segment : fitted["segments"])
    EXPECT_EQ(segment["reliable"], false) << segment["number"];
}

TEST_F(CliStrain, OfTheTextbookBeatAgreesWithWhatTheWallGaugeMeasures) {
  const std::string csv = path("strain.csv"), png = path("strain.png");
  const json found = runJson({"strain", "heartbeat", "--instants", "24", "--witnesses", "6000", "--csv", csv,
                              "--png", png, "--size", "900x700"});
  for (const char* key : {"definition", "gls", "gcs", "grs", "rvFreeWall", "segments", "phases", "axes"})
    EXPECT_TRUE(found.contains(key)) << key;
  EXPECT_TRUE(found["segments"][6]["deviationPercent"]["radial"].is_null()) << "a beat that is computed";
  EXPECT_EQ(found["surfaces"]["lv"], "lv");
  EXPECT_EQ(found["segments"].size(), 17U);
  EXPECT_EQ(found["phases"].size(), 24U);
  // docs/reference_values.md: 9.44 degrees between rings that lie a little further apart.
  tests::HeldValue twist("the textbook's beat: twist against reference values", 2, "degrees");
  twist.add(found["twistDegrees"].get<double>() - 9.44);
  // 57.9 % there, by volumes. A cavity whose length and girth change by these parts keeps this part of its
  // own.
  const double along = 1 + found["gls"]["peakPercent"].get<double>() / 100,
               around = 1 + found["gcs"]["peakPercent"].get<double>() / 100;
  tests::HeldValue ejected(
      "the textbook's beat: ejection fraction that follows from GLS and GCS against reference values", 3,
      "points");
  ejected.add(100 * (1 - along * around * around) - 57.9);
  // 57.3 % for the free wall there, by another gauge.
  double thickening = 0;
  for (const std::size_t lateral : {4, 5, 10, 11})
    thickening += found["segments"][lateral]["thickeningPercent"].get<double>() / 4;
  tests::HeldValue freeWall("thickening of the textbook's free wall against reference values", 15, "points");
  freeWall.add(thickening - 57.3);
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

/// A pose that makes everything smaller by a tenth shortens and thins each segment by that.
TEST_F(CliStrain, OfAPoseIsDrawnOnTheOrgan) {
  const std::string rest = path("rest.mrk.json"), pose = path("pose.mrk.json");
  runJson({"handles", "sample:heart@low", "-o", rest});
  json handles = json::parse(contents(rest));
  for (json& list : handles["markups"])
    for (json& point : list["controlPoints"])
      for (json& coordinate : point["position"])
        coordinate = 0.9 * coordinate.get<double>();
  std::ofstream(pose, std::ios::binary) << handles;
  const auto drawn = [&](const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"render", "sample:heart@low", rest,     "-o", path(name),
                                          "--size", "320x200",          "--pose", pose};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runJson(arguments);
  };
  drawn("posed.png", {});
  for (const char* direction : {"longitudinal", "circumferential", "radial"}) {
    const json found = drawn(direction + std::string(".png"), {"--strain", direction});
    ASSERT_EQ(found["strain"].size(), 1U);
    EXPECT_EQ(found["strain"][0]["direction"], direction);
    ASSERT_EQ(found["strain"][0]["segments"].size(), 17U);
    int known = 0;
    for (const json& segment : found["strain"][0]["segments"])
      if (!segment["percent"].is_null()) {
        EXPECT_NEAR(segment["percent"].get<double>(), -10, 1e-6) << direction << ' ' << segment["number"];
        ++known;
      }
    EXPECT_GE(known, 16) << direction;
    EXPECT_NE(contents(path(direction + std::string(".png"))), contents(path("posed.png"))) << direction;
  }
  expectFailure({"render", "sample:heart@low", rest, "-o", path("x.png"), "--strain", "radial"}, kUsage,
                "--pose");
  expectFailure({"render", "sample:heart@low", rest, "-o", path("x.png"), "--pose", pose, "--strain", "x"},
                kUsage, "--strain");
  expectFailure(
      {"render", "sample:heart/rv@low", rest, "-o", path("x.png"), "--pose", pose, "--strain", "radial"},
      kBadData, "left ventricle");
}

TEST_F(CliStrain, SaysWhatItLacks) {
  expectFailure({"strain", "liver.sequence.json"}, kNoInput, "liver.sequence.json");
  expectFailure({"strain", "heartbeat", "--reference", "900", "--instants", "8", "--witnesses", "2000"},
                kBadData, "phase 900");
  expectFailure({"strain", "heartbeat", "--lv", "ventricle", "--instants", "4"}, kUsage, "lv");
  expectFailure({"strain", "heartbeat", "--apex", "1,2"}, kUsage, "--apex");
}

} // namespace viscera::app::cli
