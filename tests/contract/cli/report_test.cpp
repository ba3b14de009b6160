#include <cmath>
#include <limits>

#include "build_paths.h"
#include "cli_test.h"
#include "viscera/document/open_files.h"
#include "viscera/document/session_file.h"
#include "viscera/document/undo_stack.h"
#include "viscera/live/live_binding.h"
#include "viscera/medical_io/surface_file.h"
#include "viscera/presentation/view_state.h"
#include "viscera/scene/picture.h"

namespace viscera::app::cli {

class CliReport : public CliTest {
protected:
  static void expectKeys(const json& report) {
    for (const char* key : {"pages", "pictures", "bytes", "seconds"})
      EXPECT_TRUE(report[key].is_number()) << key << " in " << report.dump(2);
    EXPECT_TRUE(report["file"].is_string());
    EXPECT_TRUE(report["title"].is_string());
    EXPECT_TRUE(report["sections"].is_array());
  }
  static std::string session(const std::string& name) {
    return VISCERA_SOURCE_DIR "/tests/gui/sessions/" + name + ".viscera";
  }
};

TEST_F(CliReport, OfASessionIsAPdfWithItsPages) {
  const json report = runJson({"report", session("stress_peak_recorded"), "-o", path("r.pdf")});
  expectKeys(report);
  EXPECT_EQ(report["bytes"], std::filesystem::file_size(path("r.pdf")));
  EXPECT_EQ(report["sections"], json::array({"Volumes", "Tissue distortion (rotational stress)", "Motion",
                                             "Files and what was done to them"}));
  EXPECT_EQ(report["pages"], 3) << "what follows a picture that goes to the next page goes there, too";
  EXPECT_EQ(report["pictures"], 10) << "as seen, six sides, the map, its course over the cycle, the volumes";
  EXPECT_EQ(contents(path("r.pdf")).substr(0, 5), "%PDF-");
  EXPECT_EQ(files(), 1);
}

TEST_F(CliReport, OfOrgansIsAPageThatNeedsNothingElse) {
  const json report = runJson({"report", put("cube.off", cubeOff(30)), put("<b>.off", cubeOff(20)), "-o",
                               path("r.html"), "--title", "Ward <7>"});
  expectKeys(report);
  EXPECT_EQ(report["pages"], 1);
  EXPECT_EQ(report["pictures"], 7);
  const std::string page = contents(path("r.html"));
  EXPECT_NE(page.find("<title>Ward &lt;7&gt;</title>"), std::string::npos);
  EXPECT_NE(page.find("&lt;b&gt;.off"), std::string::npos);
  EXPECT_EQ(page.find(folder_.filename().string()), std::string::npos) << "nothing says where the files lie";
}

TEST_F(CliReport, SaysWhatIsWrong) {
  const std::string cube = put("cube.off", cubeOff(30));
  expectFailure({"report", cube, "-o", path("r.docx")}, kUsage, ".pdf or .html");
  expectFailure({"report", path("missing.stl"), "-o", path("r.pdf")}, kNoInput, "missing.stl");
  expectFailure({"report", cube, "-o", path("no/r.pdf")}, kCannotCreate, "no");
  expectFailure({"report", session("play_recorded_locked"), cube, "-o", path("r.pdf")}, kUsage, "alone");
  EXPECT_EQ(files(), 1);
}

/// A committed session and the system's own word for its pose.
class CliCommands : public CliReport, public testing::WithParamInterface<const char*> {
protected:
  /// Where the organs of the session are: bound and posed here.
  std::map<std::string, Points> expected(const document::SessionContents& contents) {
    const presentation::ViewState view = presentation::viewFromJson(contents.view);
    const coordinates::Registry registry = coordinates::builtInRegistry();
    document::Document document;
    document::UndoStack undo(document);
    JobQueue jobs([](const std::function<void()>& work) { work(); });
    live::LiveBinding live(document, registry, jobs, {std::numeric_limits<double>::infinity(), {}});
    undo.reset(contents.state);
    if (view.shownPose.rows() == contents.state.pose->rows())
      live.showPose(view.shownPose);
    std::map<std::string, Points> points;
    for (const auto& organ : document.organs())
      points[organ->name] = live.points(organ->id);
    return points;
  }
};

TEST_P(CliCommands, RunAsAScriptGiveTheSessionsShapes) {
  const json result = runJson({"commands", session(GetParam())});
  ASSERT_TRUE(result["commands"].is_array());
  const test::ProcessResult printed = run({"commands", session(GetParam())});
  EXPECT_EQ(printed.out, result["script"]);
  test::ProcessOptions options = options_;
  options.environment["PATH"] =
      std::filesystem::path(VISCERA_PROGRAM).parent_path().string() + ":" + std::getenv("PATH");
  const test::ProcessResult ran =
      test::runProcess({"/bin/sh", "-c", "cd \"$1\" && sh ./script.sh", "sh", folder_.string(),
                        put("script.sh", result["script"].get<std::string>())},
                       options);
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  Progress progress;
  const document::OpenedSession opened =
      document::readSession(session(GetParam()), sample_organs::standardLibrary(), progress);
  for (const auto& [name, points] : expected(opened.contents)) {
    const geometry::TriangleMesh made = medical_io::readSurface(path(name + ".vtp")).mesh;
    ASSERT_EQ(made.points.rows(), points.rows());
    EXPECT_LT((made.points - points).cwiseAbs().maxCoeff(), 1e-9) << name;
  }
  // The picture is that of the session.
  runJson({"render", session(GetParam()), "-o", path("again.png")});
  EXPECT_EQ(contents(path("picture.png")), contents(path("again.png")));
  const presentation::ViewState view = presentation::viewFromJson(opened.contents.view);
  if (view.shown.stress) {
    EXPECT_TRUE(std::filesystem::exists(path("ball.stress.vtu")));
    EXPECT_GT(contents(path("ball.stress.csv")).size(), 1000u);
  }
  if (view.playing) {
    EXPECT_NE(result["script"].get<std::string>().find("viscera play"), std::string::npos);
  }
}

INSTANTIATE_TEST_SUITE_P(Committed, CliCommands,
                         testing::Values("deform_ghost_compensating", "deform_influence_translucent",
                                         "handles_cage_ghost", "handles_regions_zones",
                                         "play_recorded_locked", "play_peristalsis_light",
                                         "stress_stretch_max_limit"),
                         [](const auto& each) { return std::string(each.param); });

TEST_F(CliReport, CommandsNeedASession) {
  expectFailure({"commands", put("cube.off", cubeOff(30))}, kUsage, "not a session");
  expectFailure({"commands", path("none.viscera")}, kNoInput, "none.viscera");
}

TEST_F(CliReport, AnOrganOfASessionIsAnOrganForEveryCommand) {
  const std::string file = session("play_recorded_locked");
  for (const char* organ : {"/ball", "/1"})
    EXPECT_EQ(runJson({"handles", file + organ, "-o", path("h.mrk.json"), "--count", "8"})["organ"], "ball");
  expectFailure({"handles", file + "/liver", "-o", path("h.mrk.json")}, kUsage, "it has ball");
}

} // namespace viscera::app::cli
