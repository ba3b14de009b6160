#include "cli_test.h"
#include "shapes.h"
#include "viscera/medical_io/surface_file.h"

namespace viscera::app::cli {

class CliElasticity : public CliTest {
protected:
  void SetUp() override {
    CliTest::SetUp();
    cube_ = put("cube.off", cubeOff(10));
    rest_ = put("rest.mrk.json", markups(corners(12)));
    auto positions = corners(12);
    positions[0][0] += 3;
    pose_ = put("pose.mrk.json", markups(positions));
  }

  std::vector<std::string> elasticity(std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments = {"elasticity", cube_, "--handles",    rest_,
                                          "--pose",     pose_, "--tetrahedra", "200"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  std::string cube_, rest_, pose_;
};

TEST_F(CliElasticity, ComparesThePoseWithAnElasticOrgan) {
  const std::string out = path("moved.vtp");
  const json result = runJson(elasticity({"-o", out}));
  EXPECT_NEAR(result["dragMm"].get<double>(), 3, 1e-9);
  EXPECT_EQ(result["others"], "held");
  EXPECT_EQ(result["patches"]["moved"], 1);
  EXPECT_EQ(result["patches"]["held"], 7);
  EXPECT_GT(result["tetrahedra"], 50);
  const auto& difference = result["differenceMm"];
  EXPECT_LE(difference["median"], difference["p95"]);
  EXPECT_LE(difference["p95"], difference["max"]);
  EXPECT_NEAR(result["differencePercentOfDrag"]["max"].get<double>(), difference["max"].get<double>() / 0.03,
              1e-6);
  EXPECT_GT(result["volumeRatio"]["min"], 0);
  EXPECT_FALSE(result.contains("vonMisesKpa")) << "pascals without a material";
  EXPECT_FALSE(result.contains("energyMj"));
  EXPECT_EQ(result["file"], out);
}

TEST_F(CliElasticity, ComparesThePoseThatFreeHandlesFollow) {
  const json result =
      runJson(elasticity({"--free-handles-follow", "--hold", "H-6", "--hold", "H-7", "--hold", "H-8"}));
  EXPECT_EQ(result["patches"]["held"], 3);
  const auto& followed = result["leastEnergy"];
  EXPECT_EQ(followed["followingHandles"], 4);
  EXPECT_LT(followed["energyRatio"].get<double>(), 1);
  EXPECT_LE(followed["differenceMm"]["median"], followed["differenceMm"]["p95"]);
  EXPECT_LT(followed["differenceMm"]["p95"], result["differenceMm"]["p95"]) << "it comes nearer";
}

TEST_F(CliElasticity, SaysHowFarEachMeshIsFromTheFinest) {
  // All vertices of the cube are gripped; those of a ball are not.
  const std::string ball = path("ball.off");
  medical_io::writeSurface(ball, viscera::tests::sphere(2, 10));
  const json result = runJson({"elasticity", ball, "--handles", rest_, "--pose", pose_, "--tetrahedra", "200",
                               "--meshes", "400", "100"});
  ASSERT_EQ(result["meshes"].size(), 2U);
  const json &coarse = result["meshes"][0], &fine = result["meshes"][1];
  EXPECT_LT(coarse["tetrahedra"], fine["tetrahedra"]);
  EXPECT_GT(coarse["fromFinestPercentOfDrag"]["max"], 0);
  EXPECT_EQ(fine["fromFinestPercentOfDrag"]["max"], 0);
  EXPECT_GT(fine["differencePercentOfDrag"]["max"], 0);
  EXPECT_TRUE(result["order"].is_null()) << "two meshes have no order";
  expectFailure(elasticity({"--meshes", "400"}), kUsage, "two sizes");
}

TEST_F(CliElasticity, HasPascalsOfAStatedMaterialOnly) {
  const json liver = runJson(elasticity({"--material", "liver"}));
  EXPECT_EQ(liver["material"]["doi"], "10.1002/jmri.24084");
  EXPECT_GT(liver["vonMisesKpa"]["max"], liver["vonMisesKpa"]["mean"]);
  const json twice = runJson(elasticity({"--young", "12.54"}));
  const double energy = liver["energyMj"];
  EXPECT_NEAR(twice["energyMj"].get<double>(), 2 * energy, 1e-3 * energy) << "twice as stiff";
  EXPECT_NEAR(twice["differenceMm"]["max"].get<double>(), liver["differenceMm"]["max"].get<double>(), 1e-5);
  expectFailure(elasticity({"--material", "hair"}), kUsage, "choose one of liver");
}

} // namespace viscera::app::cli
