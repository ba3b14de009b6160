#include <filesystem>
#include <iostream>
#include <map>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "lesson_scene.h"
#include "run_process.h"
#include "temporary_folder.h"
#include "viscera/document/measurement_commands.h"

/// Lessons as a browser shows them. Debian's Chromium is driven by check_page.py; without it these tests are
/// skipped by name (test.sh installs it).
namespace viscera::lesson {
namespace {

using nlohmann::ordered_json;

constexpr const char* kPython = "/usr/bin/python3";
constexpr const char* kChromium = "/usr/lib/chromium/chromium";
constexpr const char* kFirefox = "/usr/bin/firefox-esr";
constexpr std::size_t kMostBytes = 1'572'864; ///< 1.5 MiB
constexpr Eigen::Index kDragged = 8;          ///< A handle.
constexpr Eigen::Index kVertices = 120;       ///< That are compared.

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
  for (const ordered_json& lesson : ordered_json::parse(made.out)["lessons"])
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
    truth["whole"] = ready.reference == "heart";
    expectGood(page, truth, ready.reference);
  }
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
  truth["measurements"] = {document::measure(plan.measurements[0].measurement, source.state,
                                             [&](document::OrganId id) -> const Points& {
                                               return source.state.organ(id)->mesh->points;
                                             })
                               .rest,
                           document::measure(plan.measurements[1].measurement, source.state,
                                             [&](document::OrganId id) -> const Points& {
                                               return source.state.organ(id)->mesh->points;
                                             })
                               .rest};
  const viscera::tests::TemporaryFolder folder;
  writePage(folder.path() / "lesson.html", lesson);
  expectGood(folder.path() / "lesson.html", truth, "balls");
}

} // namespace viscera::lesson
