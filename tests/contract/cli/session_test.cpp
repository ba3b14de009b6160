#include "cli_test.h"
#include "phantom_scan.h"
#include "shapes.h"
#include "viscera/document/open_files.h"
#include "viscera/document/rig_commands.h"
#include "viscera/document/scan_item.h"
#include "viscera/document/session_file.h"
#include "viscera/document/undo_stack.h"

namespace viscera::app::cli {
namespace {

/// A cube within handles, one of them posed, as a session beside the cube's file.
class CliSession : public CliTest {
protected:
  void SetUp() override {
    CliTest::SetUp();
    put("cube.off", cubeOff(10));
    document::Document document;
    document::UndoStack undo(document);
    undo.perform(document::addOrgans({{document::readOrgan(path("cube.off")), -1}}));
    Points places(8, 3);
    for (Eigen::Index i = 0; i < 8; ++i)
      for (Eigen::Index axis = 0; axis < 3; ++axis)
        places(i, axis) = corners(20)[static_cast<std::size_t>(i)][static_cast<std::size_t>(axis)];
    document::Rig rig = document::rigAt(places);
    rig.addGroup("All", Vec3(1, 0.5, 0), {0, 1, 2, 3, 4, 5, 6, 7});
    undo.perform(document::replaceRig(rig));
    contents_.state = document.state();
    write("rest.viscera");
    Points pose = document.pose();
    pose.row(7) *= 2;
    undo.perform(document::setPose(pose));
    contents_.state = document.state();
    write("posed.viscera");
  }

  void write(const std::string& name) {
    Progress progress;
    document::writeSession(path(name), contents_, progress);
  }

  std::string drawn(const std::string& name, const std::vector<std::string>& more = {},
                    const std::string& size = "200x160") const {
    std::vector<std::string> arguments = {"render", path(name), "-o", path("p.png"), "--size", size};
    arguments.insert(arguments.end(), more.begin(), more.end());
    runJson(arguments);
    return contents(path("p.png"));
  }

  document::SessionContents contents_;
};

TEST_F(CliSession, InfoSaysWhatIsInIt) {
  const json result = runJson({"info", path("posed.viscera")});
  EXPECT_EQ(result["kind"], "session");
  EXPECT_EQ(result["organs"][0]["name"], "cube");
  EXPECT_EQ(result["organs"][0]["surface"], "found");
  EXPECT_NEAR(result["organs"][0]["volumeMl"].get<double>(), 8, 1e-9);
  EXPECT_EQ(result["handles"], 8);
  EXPECT_EQ(result["groups"][0]["name"], "All");
  EXPECT_EQ(result["cageTriangles"], 0);
  EXPECT_EQ(result["posed"], true);
  EXPECT_EQ(result["system"]["id"], "s-celestial");
  EXPECT_TRUE(result["warnings"].empty());
  EXPECT_EQ(runJson({"info", path("rest.viscera")})["posed"], false);
}

TEST_F(CliSession, InfoNamesOrgansThatChangedAndThatAreMissing) {
  put("cube.off", cubeOff(11));
  EXPECT_EQ(runJson({"info", path("posed.viscera")})["organs"][0]["surface"], "changed");
  std::filesystem::remove(path("cube.off"));
  const json result = runJson({"info", path("posed.viscera")});
  EXPECT_EQ(result["organs"][0]["surface"], "missing");
  EXPECT_EQ(result["organs"][0]["name"], "cube");
  EXPECT_NE(result["warnings"][0].get<std::string>().find("cube.off"), std::string::npos);
  EXPECT_EQ(result["handles"], 8);
}

TEST_F(CliSession, RenderDrawsItAsItIsPosedAndSeen) {
  const std::string rest = drawn("rest.viscera");
  const std::string posed = drawn("posed.viscera");
  EXPECT_NE(rest, posed);
  EXPECT_EQ(drawn("posed.viscera"), posed);
  EXPECT_NE(drawn("posed.viscera", {"--view", "left"}), posed);
  contents_.view = json::parse(
      R"({"mode": "deform", "camera": {"position": [90, -80, 70], "focus": [0, 0, 0], "up": [0, 0, 1]}})");
  write("seen.viscera");
  const std::string seen = drawn("seen.viscera");
  EXPECT_NE(seen, posed);
  EXPECT_NE(drawn("seen.viscera", {"--view", "anterior"}), seen);
}

TEST_F(CliSession, RenderColoursByTheInfluenceOfTheHandleThatWasSelected) {
  const auto view = [this](bool shown, std::size_t handle) {
    const json selection = {{"organ", contents_.state.organs->front()->id.value},
                            {"group", 0},
                            {"handles", json::array({contents_.state.rig->handles.at(handle).id.value})}};
    contents_.view =
        json{{"mode", "deform"}, {"switches", {{"handles.influence", shown}}}, {"selection", selection}};
    write("map.viscera");
    return drawn("map.viscera");
  };
  const std::string plain = view(false, 7), seventh = view(true, 7);
  EXPECT_NE(seventh, plain);
  EXPECT_NE(view(true, 0), seventh) << "another handle has another influence";
  EXPECT_EQ(view(true, 7), seventh);
}

TEST_F(CliSession, RenderDrawsTheStressMapAsItWasLookedAt) {
  const auto view = [this](const json& look, const std::string& session) {
    contents_.view = json{
        {"mode", "stress"},
        {"stress", look},
        {"switches", {{"view.ghost", true}}},
        {"selection",
         {{"organ", contents_.state.organs->front()->id.value}, {"group", 0}, {"handles", json::array()}}}};
    write(session);
    return drawn(session, {"--view", "left"});
  };
  const json whole = {{"stress/cut", false}, {"stress/witnesses", 2000}};
  json cut = whole, ratio = whole, glyphs = whole;
  cut["stress/cut"] = true;
  cut["stress/normal"] = "0 0 1";
  ratio["stress/quantity"] = "volume-ratio";
  glyphs["stress/glyphs"] = "crosses";
  const std::string map = view(whole, "stress.viscera");
  contents_.view = json::parse(R"({"mode": "explore"})");
  write("plain.viscera");
  EXPECT_NE(drawn("plain.viscera", {"--view", "left"}), map);
  EXPECT_NE(view(cut, "cut.viscera"), map);
  EXPECT_NE(view(ratio, "ratio.viscera"), map);
  EXPECT_EQ(view(whole, "stress.viscera"), map);
  EXPECT_NE(view(glyphs, "glyphs.viscera"), map);
  EXPECT_EQ(run({"render", path("glyphs.viscera"), "-o", path("p.png"), "--size", "200x160"}).err, "");
}

TEST_F(CliSession, RenderDrawsGhostsLabelsAndRegionsThatWereSwitchedOn) {
  document::Organ ball = document::makeOrgan("Ball", tests::sphere(3, 10));
  ball.id = contents_.state.organs->front()->id;
  contents_.state.organs = std::make_shared<document::OrganList>(
      document::OrganList{std::make_shared<const document::Organ>(std::move(ball))});
  const auto view = [this](const std::string& mode, const std::string& name, bool on) {
    contents_.view = json{{"mode", mode}, {"switches", {{name, on}}}};
    write("overlay.viscera");
    return drawn("overlay.viscera", {}, "600x400"); // Labels need room.
  };
  for (const std::string name : {"view.ghost", "view.labels"})
    EXPECT_TRUE(view("deform", name, true) != view("deform", name, false)) << name;
  contents_.state.system = std::make_shared<document::SystemChoice>(document::SystemChoice{"mean-value", {}});
  EXPECT_TRUE(view("handles", "handles.regions", true) != view("handles", "handles.regions", false))
      << "these coordinates have a cage";
  EXPECT_TRUE(view("deform", "handles.regions", true) == view("deform", "handles.regions", false));
}

TEST_F(CliSession, MeasurementsAreListedAndDrawnUnlessTheyWereHidden) {
  write("none.viscera");
  EXPECT_TRUE(runJson({"info", path("none.viscera")})["measurements"].empty());
  const std::string without = drawn("none.viscera");
  document::Measurement edge;
  edge.id = document::MeasurementId{900};
  edge.name = "Edge";
  edge.points.resize(2);
  edge.points[0].rest = Vec3(-10, -10, 10);
  edge.points[1].rest = Vec3(10, -10, 10);
  contents_.state.measurements = std::make_shared<document::MeasurementList>(document::MeasurementList{edge});
  write("measured.viscera");
  const json listed = runJson({"info", path("measured.viscera")})["measurements"];
  ASSERT_EQ(listed.size(), 1U);
  EXPECT_EQ(listed[0]["name"], "Edge");
  EXPECT_EQ(listed[0]["kind"], "distance");
  EXPECT_NEAR(listed[0]["valueAtRest"].get<double>(), 20, 1e-9);
  EXPECT_EQ(listed[0]["unit"], "mm");
  EXPECT_NE(drawn("measured.viscera"), without);
  contents_.view = json::parse(R"({"switches": {"view.measurements": false}})");
  write("hidden.viscera");
  EXPECT_EQ(drawn("hidden.viscera"), without);
}

TEST_F(CliSession, RenderDrawsASliceAsTheWindowShowedIt) {
  tests::LabelImage image = tests::orientedPhantomGrid(0, {0, 1, 2});
  tests::fillPhantom(image);
  Progress progress;
  contents_.state.scan = std::make_shared<const document::ScanItem>(
      document::openScanFile(put("ct.nii", tests::niftiFile(image)), {}, progress));
  const auto slice = [this](const std::string& session, const std::string& look) {
    contents_.view = json{{"format", 2}, {"mode", "deform"}, {"scan", json::parse(look)}};
    write(session);
    const json drawn =
        runJson({"render", path(session), "--slice", "axial:2", "-o", path("s.png"), "--size", "300x240"});
    EXPECT_NE(drawn["scan"], "");
    EXPECT_EQ(drawn["contours"].size(), 1U);
    return contents(path("s.png"));
  };
  const std::string plain = slice("plain.viscera", "{}");
  EXPECT_NE(slice("bent.viscera", R"({"bent": true})"), plain) << "the pose bends it";
  EXPECT_NE(slice("other.viscera", R"({"level": -300, "width": 900})"), plain);
  EXPECT_EQ(slice("again.viscera", "{}"), plain);
  expectFailure({"render", path("plain.viscera"), "--slice", "axial", "-o", path("x.png")}, kUsage,
                "axial:120");
}

TEST_F(CliSession, DamagedOnesAndOnesWithOtherThingsAreRefused) {
  put("bad.viscera", "{\"format\": \"viscera-session\"");
  expectFailure({"info", path("bad.viscera")}, kBadData, "bad.viscera");
  expectFailure({"render", path("bad.viscera"), "-o", path("x.png")}, kBadData, "bad.viscera");
  put("later.viscera", R"({"format": "viscera-session", "version": 7})");
  expectFailure({"info", path("later.viscera")}, kBadData, "update Viscera");
  expectFailure({"info", path("none.viscera")}, kNoInput, "none.viscera");
  expectFailure({"render", path("posed.viscera"), path("cube.off"), "-o", path("x.png")}, kUsage,
                "posed.viscera");
  contents_.view = json::parse(R"({"camera": "far away"})");
  write("odd.viscera");
  expectFailure({"render", path("odd.viscera"), "-o", path("x.png")}, kBadData, "--view");
  EXPECT_FALSE(std::filesystem::exists(path("x.png")));
}

} // namespace
} // namespace viscera::app::cli
