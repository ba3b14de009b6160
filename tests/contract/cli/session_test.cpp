#include "cli_test.h"
#include "viscera/session/open_files.h"
#include "viscera/session/pose_commands.h"
#include "viscera/session/session_file.h"
#include "viscera/session/undo_stack.h"

namespace viscera::app::cli {
namespace {

/// A cube within handles, one of them posed, as a session beside the cube's file.
class CliSession : public CliTest {
protected:
  void SetUp() override {
    CliTest::SetUp();
    put("cube.off", cubeOff(10));
    session::Document document;
    session::UndoStack undo(document);
    undo.perform(session::addOrgans({{session::readOrgan(path("cube.off")), -1}}));
    session::NewRig rig;
    for (const auto& corner : corners(20))
      rig.handles.push_back({Vec3(corner[0], corner[1], corner[2])});
    rig.groups.push_back({"All", Vec3(1, 0.5, 0), {0, 1, 2, 3, 4, 5, 6, 7}});
    undo.perform(session::replaceRig(rig));
    contents_.state = document.state();
    write("rest.viscera");
    Points pose = document.pose();
    pose.row(7) *= 2;
    undo.perform(session::setPose(pose));
    contents_.state = document.state();
    write("posed.viscera");
  }

  void write(const std::string& name) {
    Progress progress;
    session::writeSession(path(name), contents_, progress);
  }

  std::string drawn(const std::string& name, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"render", path(name), "-o", path("p.png"), "--size", "200x160"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    runJson(arguments);
    return contents(path("p.png"));
  }

  session::SessionContents contents_;
};

TEST_F(CliSession, InfoSaysWhatIsInIt) {
  const json result = runJson({"info", path("posed.viscera")});
  EXPECT_EQ(result["kind"], "session");
  EXPECT_EQ(result["organs"][0]["name"], "cube");
  EXPECT_EQ(result["organs"][0]["surface"], "found");
  EXPECT_NEAR(result["organs"][0]["volumeMl"].get<double>(), 8, 1e-9);
  EXPECT_EQ(result["handles"], 8);
  EXPECT_EQ(result["groups"][0]["name"], "All");
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
  contents_.view =
      R"({"mode": "deform", "camera": {"position": [90, -80, 70], "focus": [0, 0, 0], "up": [0, 0, 1]}})";
  write("seen.viscera");
  const std::string seen = drawn("seen.viscera");
  EXPECT_NE(seen, posed);
  EXPECT_NE(drawn("seen.viscera", {"--view", "anterior"}), seen);
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
  contents_.view = R"({"camera": "far away"})";
  write("odd.viscera");
  expectFailure({"render", path("odd.viscera"), "-o", path("x.png")}, kBadData, "--view");
  EXPECT_FALSE(std::filesystem::exists(path("x.png")));
}

} // namespace
} // namespace viscera::app::cli
