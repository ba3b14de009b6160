#include <algorithm>
#include <chrono>

#include "beating_labels.h"
#include "cli_test.h"
#include "label_files.h"

namespace viscera::app::cli {

/// Label maps on the command line.
class CliSegment : public CliTest {
protected:
  void SetUp() override {
    CliTest::SetUp();
    image_.indexToLps.linear() = Vec3(-1.5, 2, 2.5).asDiagonal();
    image_.fill({2, 2, 2}, {8, 9, 9}, 1);
    image_.fill({12, 2, 2}, {18, 9, 9}, 7);
    image_.at(20, 15, 13) = 7;
    map_ =
        put("map.seg.nrrd", tests::nrrdFile(image_, "right-anterior-superior",
                                            "Segment0_ID:=S1\nSegment0_Name:=liver\nSegment0_LabelValue:=1\n"
                                            "Segment1_ID:=S2\nSegment1_Name:=Kidney / left\n"
                                            "Segment1_LabelValue:=7\n"));
  }

  tests::LabelImage image_ = tests::emptyLabels();
  std::string map_;
};

TEST_F(CliSegment, WritesAClosedSurfaceForEveryLabelUnderItsName) {
  const json result = runJson({"segment", map_, "-o", path("organs")});
  ASSERT_EQ(result["organs"].size(), 2U);
  EXPECT_TRUE(result["seconds"].is_number());
  const json& liver = result["organs"][0];
  EXPECT_EQ(liver["name"], "liver");
  EXPECT_EQ(liver["label"], 1);
  EXPECT_EQ(liver["file"], path("organs/liver.vtp"));
  EXPECT_EQ(liver["closed"], true);
  const double volumeMl = 7 * 8 * 8 * 7.5 / 1000;
  EXPECT_NEAR(liver["voxelVolumeMl"].get<double>(), volumeMl, 1e-9);
  EXPECT_NEAR(liver["volumeMl"].get<double>(), volumeMl, 0.01 * volumeMl);
  EXPECT_EQ(result["organs"][1]["file"], path("organs/Kidney_left.vtp"));
  EXPECT_EQ(result["organs"][1]["pieces"], 2);

  const json info = runJson({"info", path("organs/liver.vtp")});
  EXPECT_EQ(info["vertices"], liver["vertices"]);
  EXPECT_EQ(info["triangles"], liver["triangles"]);
  EXPECT_EQ(info["name"], "liver");
  EXPECT_EQ(info["outward"], true);
  EXPECT_NEAR(info["volumeMl"].get<double>(), liver["volumeMl"].get<double>(), 1e-9);
  // The volume of the box's rounded edges and corners moves its sides out, by half a voxel.
  EXPECT_NEAR(info["boundsMm"][0].get<double>(), -8.5 * 1.5, 0.6 * 1.5);
  EXPECT_NEAR(info["boundsMm"][1].get<double>(), -1.5 * 1.5, 0.6 * 1.5);
  runJson({"segment", map_, "-o", path("gentle"), "--smoothing", "0.5"});
  const json gentle = runJson({"info", path("gentle/liver.vtp")});
  EXPECT_NEAR(gentle["boundsMm"][0].get<double>(), -8.5 * 1.5, 0.5);
  EXPECT_NEAR(gentle["boundsMm"][1].get<double>(), -1.5 * 1.5, 0.5);
}

TEST_F(CliSegment, TakesTheLabelsSizeAndFormatThatAreAskedFor) {
  const json result = runJson({"segment", map_, "-o", path("o"), "--labels", "kidney / LEFT", "--format",
                               "stl", "--triangles", "200", "--largest-piece"});
  ASSERT_EQ(result["organs"].size(), 1U);
  EXPECT_EQ(result["organs"][0]["file"], path("o/Kidney_left.stl"));
  EXPECT_LE(result["organs"][0]["triangles"], 210);
  EXPECT_EQ(result["organs"][0]["pieces"], 1);
  EXPECT_EQ(runJson({"segment", map_, "-o", path("o"), "--labels", "1,7"})["organs"].size(), 2U);
}

TEST_F(CliSegment, TakesAFolderOfMasks) {
  std::filesystem::create_directories(folder_ / "patient");
  for (std::int16_t& voxel : image_.voxels)
    voxel = voxel == 1 ? 1 : 0;
  put("patient/spleen.nii", tests::niftiFile(image_));
  const json result = runJson({"segment", path("patient"), "-o", path("o")});
  EXPECT_EQ(result["organs"][0]["name"], "spleen");
}

TEST_F(CliSegment, RefusesWhatItCannotUse) {
  expectFailure({"segment", map_, "-o", path("o"), "--labels", "spleen"}, kUsage, "spleen");
  expectFailure({"segment", put("cut.nrrd", contents(map_).substr(0, 3000)), "-o", path("o")}, kBadData,
                "cut.nrrd");
  expectFailure({"segment", path("none.nii.gz"), "-o", path("o")}, kNoInput, "none.nii.gz");
  expectFailure({"segment", map_, "-o", put("file", "")}, kCannotCreate, "file");
  EXPECT_FALSE(std::filesystem::exists(path("o")));
}

TEST_F(CliSegment, LeavesNothingWhenItIsInterrupted) {
  tests::LabelImage large = tests::emptyLabels({200, 200, 200});
  for (std::int16_t label = 1; label <= 8; ++label)
    tests::addBall(large, Vec3(50 + 100 * (label & 1), 50 + 50 * (label & 2), 50 + 25 * (label & 4)), 48,
                   label);
  const std::string file = put("large.nrrd", tests::nrrdFile(large));
  const test::ProcessResult result = interrupted({"segment", file, "-o", path("o"), "--triangles", "100"},
                                                 std::chrono::milliseconds(800), {"o"});
  EXPECT_EQ(result.exitCode, kCancelled) << result.err;
  EXPECT_FALSE(std::filesystem::exists(path("o")));
}

TEST_F(CliSegment, InfoSaysWhatIsInALabelMap) {
  const json info = runJson({"info", map_});
  EXPECT_EQ(info["kind"], "label map");
  EXPECT_EQ(info["size"], json::array({24, 20, 16}));
  EXPECT_EQ(info["spacingMm"], json::array({1.5, 2.0, 2.5}));
  EXPECT_EQ(info["space"], "RAS");
  ASSERT_EQ(info["labels"].size(), 2U);
  EXPECT_EQ(info["labels"][0]["name"], "liver");
  EXPECT_EQ(info["labels"][0]["voxels"], 7 * 8 * 8);
  EXPECT_NEAR(info["labels"][0]["volumeMl"].get<double>(), 7 * 8 * 8 * 7.5 / 1000, 1e-9);
  EXPECT_EQ(info["boundsMm"][0], -23.5 * 1.5);
  EXPECT_TRUE(info["warnings"].is_array());
  const json liver = runJson({"info", map_ + "/liver"});
  EXPECT_EQ(liver["kind"], "organ");
  EXPECT_EQ(liver["closed"], true);
}

TEST_F(CliSegment, ALabelIsAnOrganForEveryCommand) {
  const json placed =
      runJson({"handles", map_ + "/liver", "-o", path("h.mrk.json"), "--count", "12", "--enclosing"});
  EXPECT_EQ(placed["handles"], 12);
  EXPECT_EQ(runJson({"bind", map_ + "/liver", "--handles", path("h.mrk.json"), "--system",
                     "s-celestial"})["failures"],
            0);
  expectFailure({"bind", map_, "--handles", path("h.mrk.json")}, kUsage, "several organs");
  expectFailure({"bind", map_ + "/spleen", "--handles", path("h.mrk.json")}, kUsage, "spleen");
}

TEST_F(CliSegment, OfLabelMapsOverTimeOneIsChosen) {
  std::vector<tests::LabelImage> phases(3, image_);
  phases[1].fill({2, 2, 2}, {8, 9, 9}, 0);
  phases[1].fill({2, 2, 2}, {8, 9, 5}, 1);
  const std::string series = put(
      "beat.seq.nrrd", tests::sequenceNrrd(phases, "axis 0 index unit:=ms\naxis 0 index values:=0 40 80\n"));
  expectFailure({"segment", series, "-o", path("o")}, kBadData, "viscera track beat.seq.nrrd");
  expectFailure({"segment", series, "-o", path("o"), "--phase", "3"}, kUsage, "no phase 3");
  const json result = runJson({"segment", series, "-o", path("o"), "--phase", "1"});
  ASSERT_EQ(result["organs"].size(), 2U);
  EXPECT_NEAR(result["organs"][0]["voxelVolumeMl"].get<double>(), 7 * 8 * 4 * 7.5 / 1000, 1e-9);
  const json info = runJson({"info", series});
  EXPECT_EQ(info["kind"], "label map");
  EXPECT_EQ(info["phases"], 3);
  EXPECT_EQ(info["phaseTimesMs"], json::array({0.0, 40.0, 80.0}));
  EXPECT_EQ(info["labels"][0]["voxels"], 7 * 8 * 8);
  EXPECT_EQ(runJson({"info", series, "--phase", "1"})["labels"][0]["voxels"], 7 * 8 * 4);
}

} // namespace viscera::app::cli
