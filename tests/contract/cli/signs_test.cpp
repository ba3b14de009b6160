#include "signs_picture.h"

#include <algorithm>
#include <vector>

#include "cli_test.h"

namespace viscera::app::cli {

/// `--signs`: the physiology of a beating heart below the pictures of a command.
class CliSigns : public CliTest {
protected:
  /// Plays one beat of the small heart in pictures of 640 by 480 pixels, five a second: four at 75 a minute.
  json play(std::vector<std::string> more) const {
    std::vector<std::string> arguments = {"play", "heartbeat", "--organ", "sample:heart@low", "--fps",
                                          "5",    "--size",    "640x480", "--frames",         path("frames")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runJson(arguments);
  }

  /// The pictures in the order of their numbers.
  std::vector<QImage> frames() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path("frames")))
      names.push_back(entry.path().string());
    std::sort(names.begin(), names.end());
    std::vector<QImage> pictures;
    for (const std::string& name : names)
      pictures.push_back(imageOf(name));
    return pictures;
  }

  /// The part of the pixels below `top` that differ between two pictures.
  static double changedBelow(const QImage& a, const QImage& b, int top) {
    int changed = 0;
    for (int y = top; y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x)
        changed += differenceOf(a.pixelColor(x, y), b.pixelColor(x, y)) > 30;
    return static_cast<double>(changed) / (a.width() * (a.height() - top));
  }
};

TEST_F(CliSigns, TheStripOfTheTextbooksBeatHasTheInstantOfEachFrame) {
  const json played = play({"--signs", "all"});
  EXPECT_EQ(played["signs"], json::array({"ecg", "valves", "sounds"}))
      << "a textbook's beat has no pressures";
  const std::vector<QImage> pictures = frames();
  ASSERT_EQ(pictures.size(), 4u);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    ASSERT_EQ(pictures[i].size(), QSize(640, 480)) << "the signs take their room from the organs";
    EXPECT_NEAR(instantIn(pictures[i], kWholeStrip), 0.25 * static_cast<double>(i), 0.005) << "frame " << i;
  }
  EXPECT_GT(changedBelow(pictures[1], pictures[2], 480 - kWholeStrip), 1e-3) << "line and lamps move";
  EXPECT_LT(changedBelow(pictures[1], pictures[2], 480 - kWholeStrip), 0.05) << "nothing else does";
}

TEST_F(CliSigns, OnlyWhatIsChosenIsDrawn) {
  EXPECT_EQ(play({"--signs", "ecg"})["signs"], json::array({"ecg"}));
  const std::vector<QImage> pictures = frames();
  ASSERT_EQ(pictures.size(), 4u);
  EXPECT_NEAR(instantIn(pictures[2], kEcgStrip), 0.5, 0.005) << "a strip without bars is lower";
}

TEST_F(CliSigns, ACirculationHasItsPressuresAndLoopsWithTheInstant) {
  const json played = play({"--signs", "pressures,loops", "--scenario", "rest"});
  EXPECT_EQ(played["signs"], json::array({"pressures", "loops"}));
  const std::vector<QImage> pictures = frames();
  ASSERT_GE(pictures.size(), 4u);
  const int top = 480 - 480 * 36 / 100;
  int colored = 0;
  for (int y = top; y < 480; ++y)
    for (int x = 0; x < 640; ++x)
      colored += pictures[1].pixelColor(x, y).saturation() > 120;
  EXPECT_GT(colored, 200) << "curves have colours";
  EXPECT_GT(changedBelow(pictures[1], pictures[2], top), 1e-3) << "the cursor moves";
  EXPECT_LT(changedBelow(pictures[1], pictures[2], top), 0.05) << "the curves stay";
}

TEST_F(CliSigns, WhatCannotBeDrawnIsSaid) {
  const std::vector<std::string> heart = {"play", "heartbeat", "--organ", "sample:heart@low"};
  const auto with = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments = heart;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  };
  expectFailure(with({"--signs", "ecg"}), kUsage, "--movie");
  expectFailure(with({"--signs", "loops", "--frames", path("f")}), kUsage, "need a circulation");
  expectFailure(with({"--signs", "pulse", "--frames", path("f")}), kUsage, "pulse");
  expectFailure(with({"--signs", "all", "--size", "320x100", "--frames", path("f")}), kUsage,
                "pixels high at least");
  expectFailure(
      {"play", "peristalsis", "--organ", "sample:stomach@low", "--signs", "ecg", "--frames", path("f")},
      kUsage, "This motion tells none of them");
  expectFailure({"render", "sample:heart@low", "-o", path("h.png"), "--signs", "ecg"}, kUsage,
                "Only a session");
  EXPECT_EQ(files(), 0) << "nothing is written";
}

} // namespace viscera::app::cli
