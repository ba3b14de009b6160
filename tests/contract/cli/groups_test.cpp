#include "build_paths.h"
#include "cli_test.h"

namespace viscera::app::cli {

/// Groups of handles and the coordinates that look at them, which come from a plugin.
class CliGroups : public CliTest {
protected:
  void SetUp() override {
    CliTest::SetUp();
    organ_ = put("cube.off", cubeOff(10));
  }

  static json list(const std::string& name, const std::vector<std::array<double, 3>>& positions,
                   const std::string& prefix) {
    json points = json::array();
    for (std::size_t i = 0; i < positions.size(); ++i)
      points.push_back({{"id", std::to_string(i + 1)},
                        {"label", prefix + std::to_string(i + 1)},
                        {"position", positions[i]},
                        {"positionStatus", "defined"}});
    return {{"type", "Fiducial"},
            {"name", name},
            {"coordinateSystem", "LPS"},
            {"coordinateUnits", "mm"},
            {"controlPoints", points}};
  }

  std::string handleFile(const std::string& name, const std::vector<json>& lists) const {
    return put(name, json{{"markups", lists}}.dump());
  }

  /// The corners of a box.
  static std::vector<std::array<double, 3>> box(const std::array<double, 3>& low,
                                                const std::array<double, 3>& high) {
    std::vector<std::array<double, 3>> result;
    for (int i = 0; i < 8; ++i)
      result.push_back({i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2]});
    return result;
  }

  std::vector<std::string> bind(const std::string& handles) const {
    return {"bind", organ_, "--handles", handles, "--system", "localised-s-celestial"};
  }

  json leftHalf() const { return list("left", box({-20, -20, -20}, {4, 20, 20}), "L-"); }
  json rightHalf() const { return list("right", box({-5, -21, -21}, {20, 21, 21}), "R-"); }

  std::string organ_;
};

TEST_F(CliGroups, SystemsNamesThePluginsFileAsTheSource) {
  const json systems = runJson({"systems"});
  for (const json& system : systems["systems"]) {
    if (system["id"] != "localised-s-celestial")
      continue;
    const std::string source = system["source"];
    EXPECT_NE(source.find("localised_scc_plugin"), std::string::npos) << source;
    EXPECT_TRUE(std::filesystem::exists(source)) << source;
    EXPECT_EQ(system["traits"]["usesGroups"], true);
    return;
  }
  ADD_FAILURE() << "the plugin is not loaded";
}

TEST_F(CliGroups, HandlesMakesAListForEachGroupThatBindTakes) {
  const std::string organ = "sample:stomach@low";
  for (const std::string way : {"axis", "cluster", "organ"}) {
    const std::string handles = path(way + ".mrk.json");
    const json made = runJson({"handles", organ, "-o", handles, "--groups", "3", "--group-by", way});
    const std::size_t groups = way == "organ" ? 1 : 3;
    EXPECT_EQ(made["groups"].size(), groups) << way;
    EXPECT_EQ(made["outsideHull"], 0) << way;
    EXPECT_EQ(json::parse(contents(handles))["markups"].size(), groups) << way;
    const json bound = runJson({"bind", organ, "--handles", handles, "--system", "localised-s-celestial",
                                "--param", "offset=2", "--param", "locality=1"});
    EXPECT_EQ(bound["failures"], 0) << way;
    EXPECT_LT(bound["identityError"].get<double>(), 1e-9) << way;
    EXPECT_LT(bound["unityError"].get<double>(), 1e-9) << way;
    EXPECT_GE(bound["minWeight"].get<double>(), 0) << way;
    EXPECT_EQ(bound["handles"], made["handles"]) << "a handle of two lists is one handle";
  }
  expectFailure({"handles", organ, "-o", path("x.mrk.json"), "--groups", "0"}, kUsage, "--groups");
  expectFailure({"handles", organ, "-o", path("x.mrk.json"), "--group-by", "colour"}, kUsage, "--group-by");
}

TEST_F(CliGroups, AnOffsetBeyondItsBoundIsCutAndSaid) {
  const std::string handles = handleFile("two.mrk.json", {leftHalf(), rightHalf()});
  auto command = bind(handles);
  command.insert(command.end(), {"--param", "offset=500", "--json"});
  const test::ProcessResult result = run(command);
  EXPECT_EQ(result.exitCode, kOk) << result.err;
  EXPECT_NE(result.err.find("offset of region 'left' is cut"), std::string::npos) << result.err;
  const json bound = json::parse(result.out);
  ASSERT_EQ(bound["warnings"].size(), 2u) << bound.dump(2);
  EXPECT_NE(bound["warnings"][0].get<std::string>().find("left"), std::string::npos);
  EXPECT_LT(bound["identityError"].get<double>(), 1e-9);

  const json posed = runJson({"deform", organ_, "--handles", handles, "--pose", handles, "--system",
                              "localised-s-celestial", "--param", "offset=500"});
  EXPECT_EQ(posed["warnings"], bound["warnings"]);
  const json quiet = runJson(
      {"bind", organ_, "--handles", handles, "--system", "localised-s-celestial", "--param", "offset=1"});
  EXPECT_TRUE(quiet["warnings"].empty());
}

TEST_F(CliGroups, AGroupOfThreeHandlesIsNamed) {
  auto few = box({-20, -20, -20}, {20, 20, 20});
  few.resize(3);
  const std::string handles = handleFile(
      "few.mrk.json", {list("all", box({-30, -30, -30}, {30, 30, 30}), "A-"), list("apex", few, "B-")});
  expectFailure(bind(handles), kBadData, "group 'apex': It has 3 handles");
}

TEST_F(CliGroups, AFlatGroupIsNamed) {
  auto flat = box({-20, -20, 5}, {20, 20, 6});
  flat.resize(4);
  const std::string handles = handleFile(
      "flat.mrk.json", {list("all", box({-30, -30, -30}, {30, 30, 30}), "A-"), list("wall", flat, "B-")});
  expectFailure(bind(handles), kBadData, "group 'wall'");
  expectFailure(bind(handles), kBadData, "plane");
}

TEST_F(CliGroups, VerticesInNoRegionAreCountedAndNothingIsWritten) {
  const std::string handles =
      handleFile("gap.mrk.json", {leftHalf(), list("far", box({15, -20, -20}, {40, 20, 20}), "F-")});
  const std::string out = path("w.npy");
  auto command = bind(handles);
  command.insert(command.end(), {"-o", out});
  expectFailure(command, kBadData, "4 of 8 vertices lie in no group's region");
  expectFailure(command, kBadData, "add a group that encloses them");
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(CliGroups, AParameterOutOfRangeIsRefused) {
  const std::string handles = handleFile("two.mrk.json", {leftHalf(), rightHalf()});
  for (const std::string wrong :
       {"offset=0", "offset=-3", "offset=nan", "locality=7", "inner=green", "h=3"}) {
    auto command = bind(handles);
    command.insert(command.end(), {"--param", wrong});
    expectFailure(command, kUsage, wrong.substr(0, wrong.find('=')));
  }
}

TEST_F(CliGroups, RenderComparesAHandlesReachUnderTwoSystems) {
  const std::string organ = "sample:stomach@low", handles = path("h.mrk.json"), png = path("two.png");
  runJson({"handles", organ, "-o", handles, "--groups", "4"});
  const json drawn = runJson({"render", organ, handles, "-o", png, "--size", "640x320", "--influence", "H-3",
                              "--beside", "localised-s-celestial", "--param", "offset=5", "--regions"});
  ASSERT_EQ(drawn["influence"].size(), 2u);
  const json &plain = drawn["influence"][0], &local = drawn["influence"][1];
  EXPECT_EQ(plain["system"], "s-celestial");
  EXPECT_EQ(plain["reached"], plain["vertices"]) << "global coordinates reach everything";
  EXPECT_LT(local["reached"].get<int>(), local["vertices"].get<int>());
  EXPECT_GT(local["reached"].get<int>(), 0);
  EXPECT_EQ(drawn["width"], 640);
  EXPECT_GT(std::filesystem::file_size(png), 10000u);
  expectFailure({"render", organ, handles, "-o", png, "--beside", "nowhere"}, kUsage, "nowhere");
  expectFailure({"render", organ, "-o", png, "--regions"}, kUsage, "handle file");
}

/// A plugin that cannot be used is named, and the program goes on.
class CliPlugins : public CliTest {
protected:
  void expectNamed(const std::string& file, const std::string& says) const {
    const test::ProcessResult result = run({"systems", "--json", "--plugin-path", file});
    EXPECT_EQ(result.exitCode, kOk) << result.err;
    EXPECT_NE(result.err.find(file), std::string::npos) << result.err;
    EXPECT_NE(result.err.find(says), std::string::npos) << result.err;
    EXPECT_EQ(json::parse(result.out)["systems"].size(), runJson({"systems"})["systems"].size());
  }
  const std::string good_ = VISCERA_BINARY_DIR "/lib/viscera/plugins/localised_scc_plugin.so";
  const std::string faulty_ = VISCERA_BINARY_DIR "/tests/plugins/";
};

TEST_F(CliPlugins, MissingTruncatedForeignAndOutdatedFilesAreNamed) {
  expectNamed(path("nowhere.so"), "no such file");
  expectNamed(put("half.so", contents(good_).substr(0, 20000)), "");
  expectNamed(put("letter.so", "Dear reader"), "not a Viscera plugin");
  expectNamed(faulty_ + "plugin_old.so", "version 0");
  expectNamed(faulty_ + "plugin_throws.so", "no disk in drive");
}

TEST_F(CliPlugins, ASecondPluginOfOneIdIsNamedWithTheFirst) {
  const std::string copy = put("copy.so", contents(good_));
  const test::ProcessResult result = run({"systems", "--json", "--plugin-path", copy});
  EXPECT_EQ(result.exitCode, kOk);
  EXPECT_NE(result.err.find("already a coordinate system"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("localised-s-celestial"), std::string::npos) << result.err;
}

TEST_F(CliPlugins, AFaultyOneDoesNotKeepBindFromRunning) {
  const std::string organ = put("cube.off", cubeOff(4)), handles = put("h.mrk.json", markups(corners(10)));
  const test::ProcessResult result =
      run({"bind", organ, "--handles", handles, "--json", "--plugin-path", faulty_ + "plugin_throws.so"});
  EXPECT_EQ(result.exitCode, kOk) << result.err;
  EXPECT_EQ(json::parse(result.out)["failures"], 0);
}

} // namespace viscera::app::cli
