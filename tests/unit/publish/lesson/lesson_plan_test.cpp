#include "viscera/lesson/lesson_plan.h"

#include <set>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "lesson_scene.h"
#include "page_json.h"
#include "viscera/core/error.h"
#include "viscera/document/key_sequence_commands.h"
#include "viscera/document/measurement_commands.h"
#include "viscera/heart/clinical_numbers.h"
#include "viscera/sequences/keyframes.h"

namespace viscera::lesson {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

document::NewOrgan named(const std::string& name, const std::string& file = {}) {
  document::NewOrgan organ = viscera::tests::ball(name);
  organ.organ.file = file;
  return organ;
}

std::vector<std::string> titlesOf(const LessonPlan& plan) {
  std::vector<std::string> titles;
  for (const PlannedSurface& surface : plan.surfaces)
    titles.push_back(surface.title);
  return titles;
}

/// A scene of these organs only.
struct Organs : BallScene {
  explicit Organs(std::vector<document::NewOrgan> organs) {
    undo.perform(document::removeAllOrgans());
    undo.perform(document::addOrgans(std::move(organs)));
  }
  LessonPlan plan(const LessonSpec& spec = {}) const { return planLesson(source(nullptr), spec); }
};

} // namespace

TEST(LessonPlan, TellsNoFilesName) {
  const Organs scene({named("Meier_Hans_1954_liver", "/home/doctor/Meier_Hans_1954_liver.stl"),
                      named("scan 17", "/data/scan 17.vtk"), named("Kidney_left", "/data/Kidney_left.stl"),
                      named("My own name", "/data/other.stl"),
                      named("abdomen/spleen", "/data/abdomen.nrrd")});
  EXPECT_THAT(titlesOf(scene.plan()), ElementsAre("Liver", "Organ", "Left kidney", "My own name", "Spleen"));
}

TEST(LessonPlan, SpellsVentriclesOutAndKnowsWhatHealthyPeopleHave) {
  const Organs scene({named("LV"), named("RV")});
  const LessonPlan plan = scene.plan();
  EXPECT_THAT(titlesOf(plan), ElementsAre("Left ventricle", "Right ventricle"));
  EXPECT_TRUE(plan.surfaces[0].ejects && plan.surfaces[1].ejects);
  EXPECT_TRUE(plan.surfaces[0].output);
  EXPECT_FALSE(plan.surfaces[1].output) << "the cardiac output is the left ventricle's";
  ASSERT_EQ(plan.ranges.size(), 6u) << "both ventricles have an ejection fraction";
  EXPECT_THAT(plan.ranges[0].text, HasSubstr("Left ventricle, end-diastolic volume"));
  EXPECT_THAT(plan.notes, HasSubstr("10.1186/s12968-017-0327-9"));
}

TEST(LessonPlan, LeavesHiddenOrgansOut) {
  std::vector<document::NewOrgan> organs = {named("Heart"), named("Secret")};
  organs[1].organ.look.visible = false;
  const Organs scene(organs);
  EXPECT_THAT(titlesOf(scene.plan()), ElementsAre("Heart"));
  organs[0].organ.look.visible = false;
  EXPECT_THROW(Organs(organs).plan(), UsageError);
}

TEST(LessonPlan, TakesNamesSlidesAndLabelsFromItsFile) {
  const LessonSpec spec =
      readSpec(R"({"title": "T", "notes": "N", "names": {"Ball": "Sphere", "sway": "Swing"},
      "labels": [{"surface": "Ball", "text": "Top", "at": [0, 0, 30]}, {"surface": "Other", "text": "X", "at": [0, 0, 0]}],
      "slides": [{"title": "S", "hidden": ["Ball"], "phase": "sway", "rate": 70, "seeThrough": 0.2},
                 {"title": "U", "position": [0, -300, 0], "focus": [0, 0, 0], "fraction": 0.25}], "handles": 5})",
               "test");
  BallScene scene;
  const LessonSource source = scene.source(scene.sway());
  const LessonPlan plan = planLesson(source, spec);
  EXPECT_EQ(plan.title, "T");
  EXPECT_THAT(titlesOf(plan), ElementsAre("Sphere"));
  ASSERT_EQ(plan.surfaces[0].labels.size(), 1u);
  EXPECT_EQ(plan.phases[0].title, "Swing");
  EXPECT_THAT(plan.slides[0].hiddenSurfaces, ElementsAre(0u));
  EXPECT_FALSE(plan.ownHandles);
  const Lesson lesson = scene.made(source, spec);
  const auto at = lesson.rest.row(lesson.surfaces[0].labels[0]);
  EXPECT_LT((at - Vec3(0, 0, 30).transpose()).norm(), 3);
  ArrayPacker packer;
  const auto json = nlohmann::json::parse(pageJson(lesson, packer));
  EXPECT_EQ(json["slides"][0]["fraction"], 0.5) << "the middle of the phase";
  EXPECT_EQ(json["slides"][1]["fraction"], 0.25);
  EXPECT_EQ(json["motion"]["phases"][0][0][0], "Swing");
  EXPECT_EQ(lesson.weights.rows(), 5);
}

TEST(LessonPlan, RefusesASpecThatSpeaksOfNothing) {
  EXPECT_THROW(readSpec("{\"slides\": [{\"text\": 1}]}", "test"), DataError);
  EXPECT_THROW(readSpec("no json", "test"), DataError);
  const auto refusal = [](const char* text) {
    try {
      readSpec(text, "test");
    } catch (const DataError& error) {
      return error.problem().english();
    }
    return std::string();
  };
  EXPECT_EQ(refusal("{\"title\": \"T\",\n\"notes\" \"N\"}"),
            "It is not complete JSON: the mistake is in line 2");
  EXPECT_EQ(refusal("{\"labels\": [{\"surface\": \"Ball\"}]}"),
            "It does not describe a lesson: \"text\" is missing");
  EXPECT_EQ(refusal("{\"title\": 7}"),
            "It does not describe a lesson: a text, a number or a list stands where "
            "something else belongs");
  try {
    readSpec(R"({"slides": [{"title": "S"}, {"title": "U", "rate": "fast"}]})", "test");
    ADD_FAILURE() << "a rate is a number";
  } catch (const DataError& error) {
    EXPECT_EQ(error.where().english(), "test, slides[1].rate");
  }
  BallScene scene;
  LessonSpec spec;
  spec.slides.push_back({.title = "S", .hidden = {"Spleen"}});
  EXPECT_THROW(planLesson(scene.source(nullptr), spec), UsageError);
  spec.slides = {{.title = "S", .phase = "no phase"}};
  EXPECT_THROW(planLesson(scene.source(scene.sway()), spec), UsageError);
  LessonSpec fast;
  fast.rates = {500};
  EXPECT_THROW(planLesson(scene.source(scene.sway()), fast), UsageError);
}

TEST(LessonPlan, OffersFewRatesAndTheSequencesOwn) {
  BallScene scene;
  const std::vector<double> rates = offeredRates(*scene.sway());
  EXPECT_LE(rates.size(), kMostRates);
  EXPECT_TRUE(std::is_sorted(rates.begin(), rates.end()));
  EXPECT_EQ(std::count(rates.begin(), rates.end(), 60), 1);
  EXPECT_GE(rates.front(), 10);
  EXPECT_LE(rates.back(), 120);
}

TEST(LessonPlan, KeepsTheEyeWhereTheWindowHasIt) {
  BallScene scene;
  LessonSource source = scene.source(nullptr);
  source.camera =
      presentation::Camera{.position = Vec3(0, -400, 30), .focus = Vec3(1, 2, 3), .angleDegrees = 30};
  const LessonPlan plan = planLesson(source, {});
  EXPECT_LT((plan.eye->position - Vec3(0, -400, 30)).norm(), 1e-9);
  source.camera->angleDegrees = 10;
  EXPECT_LT((planLesson(source, {}).eye->position - Vec3(1, 2, 3)).norm(), 0.4 * 403)
      << "what a narrow lens shows is seen from nearer by";
}

TEST(LessonPlan, HasTheSessionsSlidesInOrderBeforeThoseOfItsFile) {
  BallScene scene;
  LessonSource source = scene.source(scene.sway());
  source.slides = {
      {"Whole", {.position = Vec3(0, -400, 0), .angleDegrees = 30}, {}},
      {"Turned", {.position = Vec3(300, 0, 9), .focus = Vec3(0, 0, 9), .angleDegrees = 30}, 0.25}};
  LessonSpec spec;
  spec.slides = {{.title = "Last"}};
  const LessonPlan plan = planLesson(source, spec);
  ASSERT_EQ(plan.slides.size(), 3u);
  EXPECT_EQ(plan.slides[0].title, "Whole");
  EXPECT_FALSE(plan.slides[0].fraction) << "the motion goes on";
  EXPECT_EQ(plan.slides[1].fraction, 0.25);
  EXPECT_LT((plan.slides[1].eye->position - Vec3(300, 0, 9)).norm(), 1e-9);
  EXPECT_EQ(plan.slides[2].title, "Last");
  ArrayPacker packer;
  const auto json =
      nlohmann::json::parse(pageJson(makeLesson(plan, source, scene.live, scene.progress), packer));
  EXPECT_EQ(json["slides"][1]["fraction"], 0.25);
  EXPECT_EQ(json["slides"][1]["focus"], nlohmann::json::parse("[0.0, 0.0, 9.0]"));
  EXPECT_FALSE(json["slides"][0].contains("names")) << "names stay as the reader has them";
  source.sequence = nullptr;
  EXPECT_FALSE(planLesson(source, spec).slides[1].fraction) << "still organs know no instant";
}

TEST(LessonPlan, OfASampleOrganTakesWhatSpeaksOfItsMotionOnlyWithThatMotion) {
  SampleScene scene("breathing");
  LessonSource source = scene.source;
  const LessonSpec ready = readySpecFor(source);
  EXPECT_GE(ready.slides.size(), 4u);
  EXPECT_FALSE(ready.title.empty());
  source.slides = {{"Mine", {.position = Vec3(0, -400, 0)}, {}}};
  EXPECT_TRUE(readySpecFor(source).slides.empty()) << "who has slides shows these";
  source.slides.clear();
  scene.undo.perform(document::recordKey(0));
  source.state = scene.document.state();
  source.sequence = document::sequenceOf(*source.state.keySequence, *source.state.rig);
  const LessonSpec recorded = readySpecFor(source);
  EXPECT_TRUE(recorded.slides.empty() && recorded.rates.empty() && recorded.title.empty());
  EXPECT_THAT(planLesson(source, recorded).notes, HasSubstr("not a medical device"));
}

TEST(LessonPlan, NamesThePartsOfASampleOrganByItsDefinitionUnlessTheLessonNamesThem) {
  SampleScene scene("breathing");
  const auto& places = scene.document.organs().front()->places;
  const std::vector<PlannedLabel> labels =
      planLesson(scene.source, readySpecFor(scene.source)).surfaces[0].labels;
  ASSERT_EQ(labels.size(), places.size());
  EXPECT_GE(labels.size(), 6u);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    EXPECT_EQ(labels[i].text, places[i].name);
    EXPECT_EQ(labels[i].at, places[i].at);
  }
  LessonSpec spec;
  spec.labels = {{"outer", "The organ of bile", {0, 0, 0}}};
  const std::vector<PlannedLabel> own = planLesson(scene.source, spec).surfaces[0].labels;
  ASSERT_EQ(own.size(), 1u);
  EXPECT_EQ(own[0].text, "The organ of bile");
  EXPECT_TRUE(planLesson(BallScene().source(nullptr), {}).surfaces[0].labels.empty());
}

TEST(LessonPlan, ChartsAVentricleThatIsSeenThrough) {
  std::vector<document::NewOrgan> organs = {named("LV"), named("Wall")};
  for (document::NewOrgan& organ : organs)
    organ.organ.look.opacity = 0.3;
  const LessonPlan plan = Organs(organs).plan();
  EXPECT_TRUE(plan.surfaces[0].charted);
  EXPECT_FALSE(plan.surfaces[1].charted) << "beside it the wall would press its curve flat";
}

TEST(LessonPlan, SpeaksTheLanguageThatIsAskedFor) {
  LessonSpec spec = readSpec(R"({"language": "de"})", "test");
  EXPECT_THAT(titlesOf(Organs({named("LV"), named("Meier_liver", "/data/Meier_liver.stl")}).plan(spec)),
              ElementsAre("Linker Ventrikel", "Leber"));
  spec.language = "xx";
  EXPECT_THROW(Organs({named("LV")}).plan(spec), UsageError);
}

TEST(LessonPlan, SaysInItsLanguageWhoWasMeasured) {
  const std::vector<std::string> names = {"LV",     "RV",       "Stomach",    "Liver",
                                          "Spleen", "Pancreas", "kidney_left"};
  std::vector<document::NewOrgan> organs;
  for (const std::string& name : names)
    organs.push_back(named(name));
  const Organs scene(organs);
  LessonSpec spec;
  spec.language = "en";
  EXPECT_THAT(scene.plan(spec).notes, HasSubstr("women, mean +- 2 standard deviations; 800 healthy"));
  for (const char* language : {"de", "es", "fr", "ca"}) {
    spec.language = language;
    const std::string notes = scene.plan(spec).notes;
    EXPECT_THAT(notes, HasSubstr("10.1186/s12968-017-0327-9")) << language;
    for (const std::string& name : names)
      for (const heart::NormalRange& range : heart::normalRanges(name, presentation::ViewState().person)) {
        EXPECT_THAT(notes, Not(HasSubstr(range.meaning.english()))) << language;
        EXPECT_THAT(notes, Not(HasSubstr(range.people))) << language;
      }
  }
  spec.language = "de";
  EXPECT_THAT(scene.plan(spec).notes, HasSubstr("Frauen, Mittel \u00b1 2 Standardabweichungen; 800 "));
}

TEST(LessonPlan, KnowsWhatHealthyPeopleHaveInEveryLanguage) {
  const Organs scene({named("Meier_liver", "/data/Meier_liver.stl"), named("abdomen/spleen")});
  LessonSpec spec;
  for (const char* language : {"en", "de", "es", "fr", "ca"}) {
    spec.language = language;
    EXPECT_EQ(scene.plan(spec).ranges.size(), 2u) << language;
  }
}

TEST(LessonPlan, NamesThePhasesOfAKeySequenceInItsLanguage) {
  sequences::KeyframedSequence::Track track;
  track.restHandles = Points::Zero(2, 3);
  track.periodSeconds = 4;
  track.keys = {{1, track.restHandles}, {2, track.restHandles}};
  BallScene scene;
  const LessonSource source = scene.source(std::make_shared<sequences::KeyframedSequence>(track));
  LessonSpec spec;
  const auto titles = [&](const char* language) {
    spec.language = language;
    std::vector<std::string> all;
    for (const PlannedPhase& phase : planLesson(source, spec).phases)
      all.push_back(phase.title);
    return all;
  };
  EXPECT_THAT(titles("en"), ElementsAre("Start", "Key 1", "Key 2"));
  EXPECT_THAT(titles("de"), ElementsAre("Anfang", "Schl\u00fcsselbild 1", "Schl\u00fcsselbild 2"));
  EXPECT_THAT(titles("es"), ElementsAre("Inicio", "Fotograma clave 1", "Fotograma clave 2"));
}

/// Whoever looks at the texts of a plan has seen all that a document says in the file.
TEST(LessonPlan, ListsEveryTextThatWillBeInTheFile) {
  BallScene scene;
  const document::Organ& ball = *scene.document.organs().front();
  scene.undo.perform(document::addMeasurement(
      {document::nearestPoint(ball, {30, 0, 0}), document::nearestPoint(ball, {-30, 0, 0})}, "Width"));
  LessonSpec spec;
  spec.title = "Title";
  spec.labels = {{"Ball", "Top", {0, 0, 30}}};
  spec.slides = {{.title = "Slide", .text = "Text of it"}};
  const LessonSource source = scene.source(scene.sway());
  LessonPlan plan = planLesson(source, spec);
  std::set<std::string> known;
  int next = 0;
  for (LessonText& text : textsOf(plan)) {
    EXPECT_FALSE(text.kind.empty());
    *text.text = "word " + std::to_string(next++);
    known.insert(*text.text);
  }
  EXPECT_GE(known.size(), 17u);
  ArrayPacker packer;
  auto json = nlohmann::json::parse(pageJson(makeLesson(plan, source, scene.live, scene.progress), packer));
  json.erase("strings"); // What the page itself says.
  for (const char* key : {"format", "language"})
    json.erase(key);
  const std::set<std::string> kinds = {"ml", "percent", "distance", "angle"};
  const auto flat = json.flatten();
  for (const auto& [path, value] : flat.items())
    if (value.is_string()) {
      EXPECT_TRUE(known.count(value) || kinds.count(value)) << path << ": " << value;
    }
}

TEST(LessonPlan, OfWhatComesWithTheProgramIsComplete) {
  for (const std::string id : {"heartbeat", "peristalsis", "breathing"}) {
    const LessonSpec spec = readySpec(id);
    EXPECT_FALSE(spec.title.empty()) << id;
    EXPECT_GE(spec.slides.size(), 4u) << id;
    EXPECT_THAT(spec.notes, HasSubstr("not a medical device")) << id;
  }
  EXPECT_TRUE(readySpec("keyframes").title.empty());
}

} // namespace viscera::lesson
