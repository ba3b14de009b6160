#include <chrono>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "lesson_scene.h"
#include "run_process.h"
#include "sequence_scene.h"
#include "temporary_folder.h"
#include "viscera/document/measurement_commands.h"
#include "viscera/document/open_files.h"
#include "viscera/geometry/volume.h"

/// Lessons as a browser shows them. Debian's Chromium is driven by check_page.py; without it these tests are
/// skipped by name (test.sh installs it).
namespace viscera::lesson {
namespace {

using nlohmann::ordered_json;

constexpr const char* kPython = "/usr/bin/python3";
constexpr const char* kChromium = "/usr/lib/chromium/chromium";
constexpr std::size_t kMostBytes = 1'572'864; ///< 1.5 MiB
constexpr Eigen::Index kDragged = 8;          ///< A handle.
constexpr Eigen::Index kVertices = 120;       ///< That are compared.

bool browserIsThere() {
  const char* chosen = std::getenv("CHROMIUM");
  return std::filesystem::exists(chosen ? chosen : kChromium) && std::filesystem::exists(kPython);
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
      GTEST_SKIP() << "chromium is not installed (apt-get install chromium)";
  }

  /// What `check_page.py` holds a lesson against.
  static ordered_json truthOf(const Lesson& lesson, const LessonSource& source, live::PosedOrgans& organs) {
    ordered_json truth = {{"title", lesson.plan.title},
                          {"moves", source.sequence != nullptr},
                          {"whole", true},
                          {"quiz", 0},
                          {"texts", ordered_json::array()},
                          {"vertices", ordered_json::array()},
                          {"instants", ordered_json::array()}};
    for (const PlannedSurface& surface : lesson.plan.surfaces)
      truth["texts"].push_back(surface.title);
    const Eigen::Index step = std::max<Eigen::Index>(1, lesson.vertexCount() / kVertices);
    for (Eigen::Index vertex = 0; vertex < lesson.vertexCount(); vertex += step)
      truth["vertices"].push_back(vertex);
    for (std::size_t rate = 0; source.sequence && rate < lesson.plan.rates.size(); ++rate)
      for (const double fraction : {0.2231, 0.5012, 0.8117})
        truth["instants"].push_back(instantOf(lesson, source, organs, rate, fraction, truth["vertices"]));
    addDrag(lesson, truth);
    return truth;
  }

  /// Checks the page; `extra` for the script's options.
  static void expectGood(const Lesson& lesson, const ordered_json& truth,
                         const std::vector<std::string>& extra = {}) {
    const viscera::tests::TemporaryFolder folder;
    const std::filesystem::path page = folder.path() / "lesson.html";
    writePage(page, lesson);
    folder.put("truth.json", truth.dump());
    std::vector<std::string> command = {kPython, VISCERA_SOURCE_DIR "/tests/contract/lesson/check_page.py",
                                        page.string(), (folder.path() / "truth.json").string()};
    command.insert(command.end(), extra.begin(), extra.end());
    if (const char* kept = std::getenv("VISCERA_KEEP_LESSONS")) { // For pictures, and for Firefox.
      const auto* info = testing::UnitTest::GetInstance()->current_test_info();
      const auto target = std::filesystem::path(kept) / info->name();
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
  static ordered_json instantOf(const Lesson& lesson, const LessonSource& source, live::PosedOrgans& organs,
                                std::size_t rate, double fraction, const ordered_json& vertices) {
    const Points points = organPoints(lesson, source, organs, rate, fraction);
    ordered_json instant = {{"rate", rate},
                            {"fraction", fraction},
                            {"points", ordered_json::array()},
                            {"volumesMl", ordered_json::array()}};
    for (const auto& vertex : vertices) {
      const auto point = points.row(vertex.get<Eigen::Index>());
      instant["points"].push_back({point.x(), point.y(), point.z()});
    }
    for (const PlannedSurface& surface : lesson.plan.surfaces)
      instant["volumesMl"].push_back(organs.volume(surface.organ).nowMl);
    return instant;
  }

  static void addDrag(const Lesson& lesson, ordered_json& truth) {
    if (lesson.weights.rows() == 0)
      return;
    const Vec3 by(9, -12, 4);
    truth["drag"] = {
        {"handle", kDragged}, {"by", {by.x(), by.y(), by.z()}}, {"moved", ordered_json::array()}};
    for (const auto& vertex : truth["vertices"]) {
      const Vec3 moved = by * lesson.weights(kDragged, vertex.get<Eigen::Index>());
      truth["drag"]["moved"].push_back({moved.x(), moved.y(), moved.z()});
    }
  }
};

/// A ready lesson of the program.
struct ReadyLesson {
  document::Document document;
  document::UndoStack undo{document};
  plugin::Registry registry = plugin::builtInRegistry();
  JobQueue jobs{[](const std::function<void()>& work) { work(); }};
  live::LiveBinding live{document, registry, jobs, {std::numeric_limits<double>::infinity(), {}}};
  Progress progress;
  LessonSource source;
  Lesson lesson;
  double seconds = 0; ///< Of making and packing, after binding.

  explicit ReadyLesson(const std::string& id) {
    const motion::SequenceSetup setup = motion::setUpSequence(viscera::tests::cachedLibrary(), id,
                                                              sample_organs::Resolution::medium, progress);
    std::vector<document::NewOrgan> organs = document::organsFrom(setup.organ);
    if (organs.size() > 1)
      organs.front().organ.look.opacity = 0.3;
    undo.perform(
        document::combined("Sample", {document::addOrgans(std::move(organs)), document::replaceRig(setup.rig),
                                      document::setSystem(setup.system)}));
    source = {.state = document.state(), .sequence = setup.sequence};
    const LessonPlan plan = planLesson(source, readySpec(id));
    const auto begin = std::chrono::steady_clock::now();
    lesson = makeLesson(plan, source, live, progress);
    bytes = pageOf(lesson).size();
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    std::cout << id << ": " << bytes << " bytes, " << lesson.modes.size() << " modes, " << lesson.samples()
              << " samples, " << lesson.largestErrorMm << " mm, " << seconds << " s\n";
  }
  std::size_t bytes = 0;
};

} // namespace

TEST_F(LessonPage, OfTheHeartIsWhatTheProgramShows) {
  ReadyLesson ready("heartbeat");
  EXPECT_LE(ready.bytes, kMostBytes);
  EXPECT_LE(ready.lesson.largestErrorMm, 0.05);
  ordered_json truth = truthOf(ready.lesson, ready.source, ready.live);
  truth["quiz"] = 3; // Names, phases, what shrinks.
  expectGood(ready.lesson, truth,
             {"--references", VISCERA_SOURCE_DIR "/tests/contract/lesson/references", "heart"});
}

TEST_F(LessonPage, OfTheLiverIsWhatTheProgramShows) {
  ReadyLesson ready("breathing");
  EXPECT_LE(ready.lesson.largestErrorMm, 0.05);
  ordered_json truth = truthOf(ready.lesson, ready.source, ready.live);
  truth["quiz"] = 2;
  truth["whole"] = false;
  expectGood(ready.lesson, truth);
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
  ordered_json truth = truthOf(lesson, source, scene.live);
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
  expectGood(lesson, truth);
}

} // namespace viscera::lesson
