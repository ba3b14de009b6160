#include "cli_test.h"
#include "label_files.h"
#include "picture_check.h"

namespace viscera::app::cli {

class CliRender : public CliTest {
protected:
  /// Width and height from a PNG's header.
  static std::pair<int, int> sizeOf(const std::string& png) {
    const auto number = [&](std::size_t at) {
      int value = 0;
      for (std::size_t i = 0; i < 4; ++i)
        value = value * 256 + static_cast<unsigned char>(png.at(at + i));
      return value;
    };
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
    return {number(16), number(20)};
  }
};

TEST_F(CliRender, LandmarksAreDrawnThoughTheyAreTooFewForCoordinates) {
  const std::string organ = put("cube.off", cubeOff(20));
  const std::string landmarks = put("l.mrk.json", markups({{20, 0, 0}, {0, 20, 0}, {0, 0, 20}}));
  const json drawn = runJson({"render", organ, landmarks, "-o", path("l.png"), "--size", "160x120"});
  EXPECT_EQ(drawn["handles"], 3);
  expectFailure({"render", organ, landmarks, "-o", path("i.png"), "--influence", "H-1"}, kBadData, "four");
}

TEST_F(CliRender, WritesAPictureOfTheSizeAskedForWithoutADisplay) {
  const json result = runJson({"render", "sample:stomach@low", "-o", path("s.png"), "--size", "320x200"});
  EXPECT_EQ(result["png"], path("s.png"));
  EXPECT_EQ(sizeOf(contents(path("s.png"))), std::make_pair(320, 200));
}

TEST_F(CliRender, DrawsTheSideAskedForWithHandlesAndTheInfluenceOfOne) {
  const std::string handles = path("h.mrk.json");
  runJson({"handles", "sample:stomach@low", "-o", handles, "--count", "30", "--enclosing"});
  const auto expectReference = [&](const std::string& name, std::vector<std::string> more) {
    std::vector<std::string> arguments = {"render", "sample:stomach@low", "-o", path("p.png"), "--size",
                                          "320x200"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    runJson(arguments);
    tests::expectLooksLikeReference(scene::readPng(path("p.png")), name);
  };
  for (const std::string view : {"anterior", "posterior", "left", "right", "superior", "inferior"})
    expectReference("stomach_" + view, {"--view", view});
  expectReference("stomach_handles", {handles});
  expectReference("stomach_influence", {handles, "--influence", "H-9"});
  const std::string usual = contents(path("p.png"));
  runJson({"render", "sample:stomach@low", handles, "-o", path("p.png"), "--size", "320x200", "--influence",
           "H-9", "--color-map", "inferno"});
  EXPECT_NE(contents(path("p.png")), usual);
}

TEST_F(CliRender, DrawsASliceOfAScanWithTheContoursOfPosedOrgans) {
  tests::LabelImage image = tests::emptyLabels({40, 40, 40});
  image.indexToLps = Eigen::Translation3d(-39, -39, -39) * Eigen::Scaling(2.0);
  image.voxels.assign(image.voxels.size(), -100);
  tests::addBall(image, Vec3(19.5, 19.5, 19.5), 12.5, 80);
  put("ct.nii", tests::niftiFile(image));
  const std::string cube = put("cube.off", cubeOff(25));
  const json whole = runJson({"render", path("ct.nii"), cube, "-o", path("s.png"), "--slice", "coronal:15",
                              "--size", "300x200", "--window", "300", "--level", "0"});
  EXPECT_EQ(sizeOf(contents(path("s.png"))), std::make_pair(300, 200));
  EXPECT_EQ(whole["scan"], "ct.nii");
  ASSERT_EQ(whole["contours"].size(), 1u);
  EXPECT_EQ(whole["contours"][0]["organ"], "cube");
  EXPECT_GE(whole["contours"][0]["points"], 4);
  EXPECT_NEAR(whole["contours"][0]["lengthMm"], 200, 1e-9);
  EXPECT_TRUE(
      runJson({"render", path("ct.nii"), cube, "-o", path("s.png"), "--slice", "axial:30"})["contours"]
          .empty());
  expectFailure({"render", path("ct.nii"), "-o", path("s.png"), "--slice", "axial"}, kUsage, "axial:120");
  expectFailure({"render", path("ct.nii"), "-o", path("s.png"), "--level", "3"}, kUsage, "--slice");
}

} // namespace viscera::app::cli
