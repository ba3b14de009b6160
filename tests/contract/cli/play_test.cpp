#include <cmath>
#include <sstream>

#include "cli_test.h"

namespace viscera::app::cli {

class CliPlay : public CliTest {
protected:
  /// A table's rows as numbers, without its heading.
  static std::vector<std::vector<double>> rowsOf(const std::string& csv, std::string& heading) {
    std::istringstream lines(csv);
    std::getline(lines, heading);
    std::vector<std::vector<double>> rows;
    for (std::string line; std::getline(lines, line);) {
      std::istringstream cells(line);
      rows.emplace_back();
      for (std::string cell; std::getline(cells, cell, ',');)
        rows.back().push_back(std::stod(cell));
    }
    return rows;
  }
};

TEST_F(CliPlay, TheHeartbeatEmptiesTheVentriclesAsMeasured) {
  const json beat = runJson({"play", "heartbeat", "--csv", path("v.csv"), "--cycles", "2"});
  for (const std::string key : {"frames", "cycles", "ejectionFraction", "maxRelativeOuterChange", "seconds"})
    EXPECT_TRUE(beat[key].is_number()) << key;
  for (const std::string surface : {"outer", "lv", "rv"})
    for (const std::string key : {"minMl", "maxMl", "restMl"})
      EXPECT_TRUE(beat["volumes"][surface][key].is_number()) << surface << " " << key;
  EXPECT_EQ(beat["cycles"], 2);
  EXPECT_NEAR(beat["volumes"]["lv"]["maxMl"].get<double>(), 130.5, 0.5);
  EXPECT_NEAR(beat["volumes"]["lv"]["minMl"].get<double>(), 55.0, 0.5);
  EXPECT_NEAR(beat["volumes"]["rv"]["maxMl"].get<double>(), 138.0, 1.0);
  EXPECT_NEAR(beat["volumes"]["rv"]["minMl"].get<double>(), 66.0, 1.0);
  EXPECT_NEAR(beat["ejectionFraction"].get<double>(), 0.58, 0.005);
  EXPECT_LE(beat["maxRelativeOuterChange"].get<double>(), 0.12);

  std::string heading;
  const auto rows = rowsOf(contents(path("v.csv")), heading);
  EXPECT_EQ(heading, "time_s,outer_ml,lv_ml,rv_ml");
  ASSERT_EQ(rows.size(), beat["frames"].get<std::size_t>());
  ASSERT_EQ(rows.size(), 40u); // Two beats of 0.8 s at 25 frames a second.
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), 4u);
    EXPECT_NEAR(rows[i][0], static_cast<double>(i) / 25, 1e-6);
    EXPECT_NEAR(rows[i][2], rows[(i + 20) % 40][2], 1e-3) << "every beat is the same";
  }
}

TEST_F(CliPlay, RecordsAMovieAndFrames) {
  const json beat = runJson({"play", "heartbeat", "--organ", "sample:heart@low", "--fps", "10", "--size",
                             "320x200", "--movie", path("beat.ogv"), "--frames", path("frames.d")});
  EXPECT_EQ(beat["frames"], 8);
  EXPECT_EQ(contents(path("beat.ogv")).substr(0, 4), "OggS");
  int pictures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(path("frames.d"))) {
    ++pictures;
    EXPECT_EQ(contents(entry.path()).substr(1, 3), "PNG") << entry.path();
  }
  EXPECT_EQ(pictures, 8);
  EXPECT_EQ(files(), 2) << "nothing but the movie and the folder";
}

TEST_F(CliPlay, AFasterHeartHasShorterBeats) {
  const json fast =
      runJson({"play", "heartbeat", "--organ", "sample:heart@low", "--rate", "150", "--cycles", "3"});
  EXPECT_EQ(fast["frames"], 30);
  EXPECT_EQ(fast["ratePerMinute"], 150);
}

TEST_F(CliPlay, OutputsThatCannotBeWrittenAreSaidFirst) {
  expectFailure({"play", "heartbeat", "--organ", "sample:heart@low", "--csv", path("no such folder/v.csv")},
                kCannotCreate, "v.csv");
  expectFailure({"play", "heartbeat", "--organ", "sample:heart@low", "--movie", path("no such folder/m.ogv")},
                kCannotCreate, "m.ogv");
  expectFailure({"play", "heartbeat", "--organ", "sample:heart@low", "--movie", path("m.avi")}, kUsage,
                ".ogv");
}

} // namespace viscera::app::cli
