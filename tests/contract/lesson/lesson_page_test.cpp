#include <filesystem>
#include <iostream>
#include <map>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "beating_labels.h"
#include "build_paths.h"
#include "lesson_scene.h"
#include "run_process.h"
#include "temporary_folder.h"
#include "viscera/document/measured_values.h"
#include "viscera/document/measurement_commands.h"
#include "viscera/document/session_file.h"

/// Lessons as a browser shows them. Debian's Chromium is driven by check_page.py; without it these tests are
/// skipped by name (test.sh installs it).
namespace viscera::lesson {
namespace {

using nlohmann::ordered_json;

constexpr const char* kPython = "/usr/bin/python3";
constexpr const char* kChromium = "/usr/lib/chromium/chromium";
constexpr const char* kFirefox = "/usr/bin/firefox-esr";
constexpr std::size_t kMostBytes = 1'572'864;       ///< 1.5 MiB
constexpr std::size_t kMostOpenedBytes = 1'800'000; ///< With walls, conduction system, 60 handles.
constexpr Eigen::Index kDragged = 8;                ///< A handle.
constexpr Eigen::Index kVertices = 120;             ///< That are compared.

/// "chromium", or what VISCERA_BROWSER says: "firefox", which needs a display.
std::string browser() {
  const char* chosen = std::getenv("VISCERA_BROWSER");
  return chosen ? chosen : "chromium";
}

bool browserIsThere() {
  const char* chromium = std::getenv("CHROMIUM");
  const std::string program = browser() == "firefox" ? kFirefox : chromium ? chromium : kChromium;
  return std::filesystem::exists(program) && std::filesystem::exists(kPython);
}

std::string hostile() {
  return "</script><script>window.hostile = 1</script><img src=x onerror=\"window.hostile=2\">'\"&amp; "
         "\xE2\x80\xAE"
         "abc @SCRIPT@ " +
         std::string(10000, 'x');
}

class LessonPage : public testing::Test {
protected:
  void SetUp() override {
    if (!browserIsThere())
      GTEST_SKIP() << browser() << " is not installed (apt-get install chromium, or firefox-esr)";
  }

  /// What `check_page.py` holds a lesson against: where the organs themselves are.
  static ordered_json truthOf(const LessonPlan& plan, const LessonSource& source, live::PosedOrgans& organs) {
    ordered_json truth = {{"title", plan.title},
                          {"moves", source.sequence != nullptr},
                          {"language", plan.language.empty() ? "en" : plan.language},
                          {"eyes", true},
                          {"whole", true},
                          {"quiz", 0},
                          {"texts", ordered_json::array()},
                          {"vertices", ordered_json::array()},
                          {"instants", ordered_json::array()}};
    Eigen::Index vertices = 0;
    for (const PlannedSurface& surface : plan.surfaces) {
      truth["texts"].push_back(surface.title);
      vertices += source.state.organ(surface.organ)->mesh->points.rows();
    }
    for (Eigen::Index vertex = 0; vertex < vertices;
         vertex += std::max<Eigen::Index>(1, vertices / kVertices))
      truth["vertices"].push_back(vertex);
    for (std::size_t rate = 0; source.sequence && rate < plan.rates.size(); ++rate)
      for (const double fraction : {0.2231, 0.5012, 0.8117})
        truth["instants"].push_back(instantOf(plan, source, organs, rate, fraction, truth["vertices"]));
    return truth;
  }

  /// How far a handle is to take the vertices along.
  static void addDrag(const Lesson& lesson, ordered_json& truth) {
    const Vec3 by(9, -12, 4);
    truth["drag"] = {
        {"handle", kDragged}, {"by", {by.x(), by.y(), by.z()}}, {"moved", ordered_json::array()}};
    for (const auto& vertex : truth["vertices"]) {
      const Vec3 moved = by * lesson.weights(kDragged, vertex.get<Eigen::Index>());
      truth["drag"]["moved"].push_back({moved.x(), moved.y(), moved.z()});
    }
  }

  /// Checks the page, and its picture against the reference of that name.
  static void expectGood(const std::filesystem::path& page, const ordered_json& truth,
                         const std::string& reference) {
    const viscera::tests::TemporaryFolder folder;
    folder.put("truth.json", truth.dump());
    std::vector<std::string> command = {
        kPython,       VISCERA_SOURCE_DIR "/tests/contract/lesson/check_page.py",
        page.string(), (folder.path() / "truth.json").string(),
        "--browser",   browser(),
        "--reference", VISCERA_SOURCE_DIR "/tests/contract/lesson/references/" + reference + ".json"};
    if (const char* kept = std::getenv("VISCERA_KEEP_LESSONS")) { // For pictures, and for Firefox.
      const auto* info = testing::UnitTest::GetInstance()->current_test_info();
      const auto target = std::filesystem::path(kept) / (info->name() + ('_' + reference));
      std::filesystem::create_directories(target);
      const auto over = std::filesystem::copy_options::overwrite_existing;
      std::filesystem::copy_file(page, target / "lesson.html", over);
      std::filesystem::copy_file(folder.path() / "truth.json", target / "truth.json", over);
      command.insert(command.end(), {"--pictures", target.string()});
    }
    viscera::test::ProcessOptions options;
    options.environment = {{"PYTHONDONTWRITEBYTECODE", "1"}};
    const viscera::test::ProcessResult result = viscera::test::runProcess(command, options);
    EXPECT_EQ(result.exitCode, 0) << result.out << result.err;
    std::cout << result.out;
  }

private:
  static ordered_json instantOf(const LessonPlan& plan, const LessonSource& source, live::PosedOrgans& organs,
                                std::size_t rate, double fraction, const ordered_json& vertices) {
    const Points points = organPoints(plan, source, organs, rate, fraction);
    ordered_json instant = {{"rate", rate},
                            {"fraction", fraction},
                            {"points", ordered_json::array()},
                            {"volumesMl", ordered_json::array()}};
    for (const auto& vertex : vertices) {
      const auto point = points.row(vertex.get<Eigen::Index>());
      instant["points"].push_back({point.x(), point.y(), point.z()});
    }
    for (const PlannedSurface& surface : plan.surfaces)
      instant["volumesMl"].push_back(organs.volume(surface.organ).nowMl);
    return instant;
  }
};

/// What is between the first `open` in a file and the `close` behind it.
std::string between(const std::filesystem::path& file, const std::string& open, const std::string& close) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  const std::size_t begin = text.find(open);
  return begin == std::string::npos
             ? std::string()
             : text.substr(begin + open.size(), text.find(close, begin) - begin - open.size());
}

/// A patient's beat as it was measured: `viscera track` follows a small heart in six phases.
void track(const std::filesystem::path& folder, const std::filesystem::path& motion) {
  std::vector<viscera::tests::LabelImage> phases;
  for (int phase = 0; phase < 6; ++phase)
    phases.push_back(viscera::tests::beatingLabels(phase / 6.0, Vec3(4, 4, 8)));
  std::ofstream(folder / "cine.nii", std::ios::binary) << viscera::tests::nifti4d(phases, 150, 16);
  const auto tracked = viscera::test::runProcess({VISCERA_PROGRAM, "track", (folder / "cine.nii").string(),
                                                  "-o", motion.string(), "--handles", "60", "--surface",
                                                  "LV=1", "--surface", "RV=2", "--surface", "EPI=1,2,3"});
  ASSERT_EQ(tracked.exitCode, 0) << tracked.err;
}

} // namespace

TEST_F(LessonPage, OfEachReadyLessonIsWhatTheProgramShows) {
  struct Ready {
    std::string sequence, reference;
    int quiz; ///< How many kinds of questions there are to ask.
  };
  const viscera::tests::TemporaryFolder folder;
  const auto made = viscera::test::runProcess(
      {VISCERA_PROGRAM, "lesson", "--ready", "-o", folder.path().string(), "--json"});
  ASSERT_EQ(made.exitCode, 0) << made.err;
  std::cout << made.out;
  std::map<std::string, ordered_json> said;
  const ordered_json answer = ordered_json::parse(made.out);
  for (const ordered_json& lesson : answer["lessons"])
    said[std::filesystem::path(lesson["file"].get<std::string>()).stem()] = lesson;
  for (const Ready& ready :
       {Ready{"heartbeat", "heart", 3}, {"peristalsis", "stomach", 2}, {"breathing", "liver", 2}}) {
    SCOPED_TRACE(ready.sequence);
    const std::filesystem::path page = folder.path() / (ready.sequence + ".html");
    ASSERT_TRUE(std::filesystem::exists(page));
    EXPECT_LE(std::filesystem::file_size(page), kMostBytes);
    EXPECT_LE(said[ready.sequence]["largestErrorMm"], 0.05);
    SampleScene scene(ready.sequence, sample_organs::Resolution::medium);
    ordered_json truth =
        truthOf(planLesson(scene.source, readySpec(ready.sequence)), scene.source, scene.live);
    truth["quiz"] = ready.quiz;
    truth["whole"] = truth["eyes"] = ready.reference == "heart";
    expectGood(page, truth, ready.reference);
  }
}

TEST_F(LessonPage, OfAHeartOpensItAndLightsItsConductionSystem) {
  const viscera::tests::TemporaryFolder folder;
  const std::filesystem::path page = folder.path() / "heart.html";
  const auto made =
      viscera::test::runProcess({VISCERA_PROGRAM, "lesson", "heartbeat", "--cut", "--conduction", "--handles",
                                 "60", "-o", page.string(), "--json"});
  ASSERT_EQ(made.exitCode, 0) << made.err;
  EXPECT_LE(std::filesystem::file_size(page), kMostOpenedBytes);
  EXPECT_LE(ordered_json::parse(made.out)["largestErrorMm"], 0.05);
  viscera::test::ProcessOptions options;
  options.environment = {{"PYTHONDONTWRITEBYTECODE", "1"}};
  const viscera::test::ProcessResult result =
      viscera::test::runProcess({kPython, VISCERA_SOURCE_DIR "/tests/contract/lesson/check_heart.py",
                                 page.string(), "--browser", browser()},
                                options);
  EXPECT_EQ(result.exitCode, 0) << result.out << result.err;
}

TEST_F(LessonPage, OfASessionHasThePatientsMotionItsSlidesAndAnEyeForEachOrgan) {
  const viscera::tests::TemporaryFolder folder;
  const std::filesystem::path motion = folder.path() / "m.sequence.json";
  ASSERT_NO_FATAL_FAILURE(track(folder.path(), motion));
  MotionFileScene scene(motion);
  const document::Organ& left = *scene.document.organs().front();
  scene.undo.perform(document::addMeasurement(
      {document::nearestPoint(left, {-40, 0, 0}), document::nearestPoint(left, {20, 0, 0})}, "Width"));
  presentation::ViewState view;
  view.slides = {{"From the front", {.position = Vec3(0, -500, 20), .focus = Vec3(3, 0, 4)}, {}},
                 {"Smallest", {.position = Vec3(-300, -200, 80), .focus = Vec3(-11, 0, 0)}, 0.5}};
  document::SessionContents contents;
  contents.state = scene.document.state();
  contents.view = presentation::toJson(view);
  contents.embedSurfaces = true;
  document::writeSession(folder.path() / "s.viscera", contents, scene.progress);
  for (const std::string name : {"s.viscera", "m.sequence.json"}) {
    const auto made =
        viscera::test::runProcess({VISCERA_PROGRAM, "lesson", (folder.path() / name).string(), "--language",
                                   "de", "-o", (folder.path() / (name + ".html")).string(), "--json"});
    ASSERT_EQ(made.exitCode, 0) << made.err;
    EXPECT_LE(ordered_json::parse(made.out)["largestErrorMm"], 0.05);
  }

  LessonSource source = scene.source();
  source.slides = view.slides;
  LessonSpec german;
  german.language = "de";
  ordered_json truth = truthOf(planLesson(source, german), source, scene.live);
  truth["whole"] = false;
  truth["quiz"] = 3;
  truth["slides"] = {
      {{"title", "From the front"}, {"position", {0, -500, 20}}, {"focus", {3, 0, 4}}},
      {{"title", "Smallest"}, {"position", {-300, -200, 80}}, {"focus", {-11, 0, 0}}, {"fraction", 0.5}}};
  EXPECT_EQ(truth["texts"], ordered_json::parse(R"(["EPI", "Linker Ventrikel", "Rechter Ventrikel"])"));
  expectGood(folder.path() / "s.viscera.html", truth, "patient");

  const auto jsonOf = [&](const char* page) {
    return ordered_json::parse(between(folder.path() / page, "id=\"lesson\">", "</script>"));
  };
  const ordered_json session = jsonOf("s.viscera.html"), file = jsonOf("m.sequence.json.html");
  EXPECT_EQ(session["measurements"].size(), 1u);
  ASSERT_EQ(file["surfaces"].size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(file["surfaces"][i]["wall"], i == 0) << "the surface around the others";
    EXPECT_EQ(file["surfaces"][i]["curves"], session["surfaces"][i]["curves"])
        << "the file alone is the same motion";
  }
  EXPECT_NE(file["surfaces"][1]["color"], file["surfaces"][2]["color"]) << "ventricles are told apart";
}

TEST_F(LessonPage, OfStillOrgansWithMeasurementsAndHostileNamesStaysText) {
  BallScene scene;
  scene.undo.perform(document::addOrgans({viscera::tests::ball("Second", 18, 3, Vec3(12, 30, 8))}));
  const document::Organ& ball = *scene.document.organs().front();
  scene.undo.perform(document::addMeasurement(
      {document::nearestPoint(ball, {30, 0, 0}), document::nearestPoint(ball, {-30, 0, 0})}, "Width"));
  scene.undo.perform(document::addMeasurement({document::nearestPoint(ball, {30, 0, 0}),
                                               document::nearestPoint(ball, {0, 0, 30}),
                                               document::nearestPoint(ball, {-30, 0, 0})},
                                              "Angle"));
  const LessonSource source = scene.source(nullptr);
  LessonSpec spec;
  spec.labels = {{"Ball", "Top", {0, 0, 30}}, {"Ball", "Front", {0, -30, 0}}};
  spec.slides = {{.title = "First", .text = "Text"}, {.title = "Second", .hidden = {"Second"}}};
  LessonPlan plan = planLesson(source, spec);
  for (LessonText& text : textsOf(plan))
    *text.text = text.kind + ' ' + hostile();
  const Lesson lesson = makeLesson(plan, source, scene.live, scene.progress);
  ordered_json truth = truthOf(plan, source, scene.live);
  addDrag(lesson, truth);
  truth["quiz"] = 1;
  truth["hostile"] = true;
  const auto valueOf = [&](const PlannedMeasurement& planned) {
    return document::measure(
               planned.measurement, source.state,
               [&](document::OrganId id) -> const Points& { return source.state.organ(id)->mesh->points; })
        .rest;
  };
  truth["measurements"] = {valueOf(plan.measurements[0]), valueOf(plan.measurements[1])};
  const viscera::tests::TemporaryFolder folder;
  writePage(folder.path() / "lesson.html", lesson);
  expectGood(folder.path() / "lesson.html", truth, "balls");
}

} // namespace viscera::lesson
