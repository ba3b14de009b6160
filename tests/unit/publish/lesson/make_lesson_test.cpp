#include <gtest/gtest.h>

#include "lesson_scene.h"

#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/geometry/volume.h"
#include "viscera/sequences/keyframes.h"
#include <algorithm>

namespace viscera::lesson {
namespace {

const std::vector<double> kBetween = {0.0017, 0.093, 0.2571, 0.4443, 0.5, 0.7129, 0.8888, 0.9973};
constexpr double kMost = 0.05; ///< mm

/// Three keys that are run through once and do not lead back.
sequences::KeyframedSequence::Track track(const Points& rest, bool loop, sequences::Easing easing) {
  sequences::KeyframedSequence::Track track;
  track.restHandles = rest;
  track.periodSeconds = 3;
  track.loop = loop;
  for (int key = 0; key < 3; ++key) {
    Points pose = rest;
    pose.row(8) += Vec3(3.0 * key, -7.0 * key, 5).transpose();
    track.keys.push_back({static_cast<double>(key), pose, easing});
  }
  return track;
}

} // namespace

TEST(MakeLesson, FollowsTheOrgansAtEveryRateAndBetweenSamples) {
  BallScene scene;
  const LessonSource source = scene.source(scene.sway());
  const Lesson lesson = scene.made(source);
  EXPECT_LT(worstOver(lesson, source, scene.live, kBetween), kMost);
  EXPECT_LE(lesson.largestErrorMm, kMost);
  EXPECT_GT(lesson.largestErrorMm, 0);
  EXPECT_LE(lesson.modes.size(), 4u) << "two handles that sway are a motion of few modes";
  EXPECT_EQ(lesson.courses.size(), 1u) << "a motion that is the same at every rate is kept once";
}

TEST(MakeLesson, OfTheHeartFollowsItAtEveryRate) {
  SampleScene scene("heartbeat");
  const LessonPlan plan = planLesson(scene.source, {});
  const Lesson lesson = makeLesson(plan, scene.source, scene.live, scene.progress);
  EXPECT_EQ(lesson.courses.size(), plan.rates.size());
  EXPECT_LT(worstOver(lesson, scene.source, scene.live, kBetween), kMost);
  EXPECT_LE(lesson.largestErrorMm, kMost);
  EXPECT_LE(lesson.modes.size(), 14u);
}

TEST(MakeLesson, OfTheStomachFollowsItsWaves) {
  SampleScene scene("peristalsis");
  LessonSpec spec;
  spec.rates = {1, 3, 6};
  const Lesson lesson = makeLesson(planLesson(scene.source, spec), scene.source, scene.live, scene.progress);
  EXPECT_LT(worstOver(lesson, scene.source, scene.live, kBetween), kMost);
}

TEST(MakeLesson, OfBreathingFollowsTheLiver) {
  SampleScene scene("breathing");
  const LessonSource& source = scene.source;
  const Lesson lesson =
      makeLesson(planLesson(source, readySpecFor(source)), source, scene.live, scene.progress);
  EXPECT_LT(worstOver(lesson, source, scene.live, kBetween), kMost);
  EXPECT_GE(lesson.plan.surfaces[0].labels.size(), 6u);
  EXPECT_GE(lesson.plan.slides.size(), 4u);
}

TEST(MakeLesson, OfAMeasuredMotionInAFileFollowsEachOfItsOrgans) {
  const viscera::tests::TemporaryFolder folder;
  BallScene ball;
  live::SequenceFile file;
  file.track = track(ball.document.rig().restPositions(), true, sequences::Easing::smooth);
  file.track.interpolation = sequences::Interpolation::curve; // As `viscera track` writes it.
  for (std::size_t i = 0; i < ball.document.rig().handles.size(); ++i)
    file.labels.push_back("H" + std::to_string(i));
  for (const auto& [name, radius] : {std::pair("LV", 12.0), {"RV", 9.0}, {"EPI", 30.0}})
    file.organs.push_back({name, viscera::tests::ball(name, radius).organ.mesh});
  live::writeSequence(folder.path() / "m.sequence.json", file);
  MotionFileScene scene(folder.path() / "m.sequence.json");
  const LessonSource source = scene.source();
  const Lesson lesson = makeLesson(planLesson(source, {}), source, scene.live, scene.progress);
  ASSERT_EQ(lesson.surfaces.size(), 3u);
  EXPECT_LT(worstOver(lesson, source, scene.live, kBetween), kMost);
  EXPECT_LE(lesson.largestErrorMm, kMost);
  for (const LessonSurface& surface : lesson.surfaces)
    EXPECT_GT(surface.curves.maxCoeff() - surface.curves.minCoeff(), 1e-3);
}

TEST(MakeLesson, KnowsTheVolumesOfItsCurves) {
  BallScene scene;
  const LessonSource source = scene.source(scene.sway());
  const Lesson lesson = scene.made(source);
  const LessonSurface& ball = lesson.surfaces.front();
  for (const Eigen::Index sample : {0, 31, 77}) {
    const Points points =
        organPoints(lesson.plan, source, scene.live, 0, fractionOf(sample, kCurveSamples, lesson.end));
    const double ml = geometry::volume(points, lesson.triangles) / kMm3PerMl;
    EXPECT_NEAR(ball.curves(0, sample), ml, 5e-4 * ml);
  }
}

TEST(MakeLesson, OfAMotionThatDoesNotLeadBackStopsAtItsEnd) {
  BallScene scene;
  const Points rest = scene.document.rig().restPositions();
  const LessonSource source = scene.source(
      std::make_shared<sequences::KeyframedSequence>(track(rest, false, sequences::Easing::smooth)));
  const Lesson lesson = scene.made(source);
  EXPECT_EQ(lesson.end, CourseEnd::stops);
  EXPECT_LT(worstOver(lesson, source, scene.live, kBetween), kMost);
}

TEST(MakeLesson, GathersItsInstantsWhereAMotionHasCorners) {
  BallScene scene;
  const Points rest = scene.document.rig().restPositions();
  const auto lessonOf = [&](sequences::Easing easing) {
    return scene.made(
        scene.source(std::make_shared<sequences::KeyframedSequence>(track(rest, true, easing))));
  };
  const LessonSource source = scene.source(
      std::make_shared<sequences::KeyframedSequence>(track(rest, true, sequences::Easing::linear)));
  const Lesson corners = scene.made(source);
  EXPECT_LT(worstOver(corners, source, scene.live, {0.33, 0.3332, 0.3334, 0.34, 0.6666, 0.67}), kMost);
  EXPECT_GT(corners.instants(), lessonOf(sequences::Easing::smooth).instants());
  EXPECT_LT(corners.instants(), 120u) << "all over the cycle they would be thousands";
}

TEST(MakeLesson, FollowsCoordinatesThatAreNoSumOfHandles) {
  BallScene scene;
  scene.undo.perform(document::takeCage({"box", viscera::tests::cubeCage()}));
  scene.undo.perform(document::setSystem({"green", {}}));
  ASSERT_EQ(scene.live.status(scene.organ()).state, live::BindingStatus::State::bound)
      << scene.live.status(scene.organ()).message;
  Points pose = scene.document.rig().restPositions();
  const LessonSource source = scene.source(std::make_shared<viscera::tests::Sway>(
      pose, std::vector<viscera::tests::Swing>{{7, Vec3(12, 9, 9), 0.4}}));
  const Lesson lesson = scene.made(source);
  EXPECT_LT(worstOver(lesson, source, scene.live, kBetween), kMost);
  EXPECT_EQ(lesson.handleLabels.size(), 22u) << "handles that are no weights are replaced by placed ones";
}

TEST(MakeLesson, KeepsALockedVolume) {
  BallScene scene;
  scene.undo.perform(document::setVolumeLocked(scene.organ(), true));
  const Lesson lesson = scene.made(scene.source(scene.sway(6)));
  const auto& curve = lesson.surfaces.front().curves;
  EXPECT_NEAR(curve.minCoeff(), curve.maxCoeff(), 5e-4 * curve.maxCoeff());
  BallScene free;
  const Lesson other = free.made(free.source(free.sway(6)));
  const auto& loose = other.surfaces.front().curves;
  EXPECT_GT(loose.maxCoeff() - loose.minCoeff(), 5e-3 * loose.maxCoeff())
      << "without the lock it would change";
}

TEST(MakeLesson, OfStillOrgansShowsThemAsTheyArePosed) {
  BallScene scene;
  Points pose = scene.document.rig().restPositions();
  pose.row(8) += Vec3(0, 0, 20).transpose();
  scene.undo.perform(document::setPose(pose));
  const LessonSource source = scene.source(nullptr);
  const Lesson lesson = scene.made(source);
  EXPECT_TRUE(lesson.courses.empty());
  const Points shown = lesson.rest.topRows(lesson.vertexCount());
  EXPECT_LT((shown - scene.live.points(scene.organ())).cwiseAbs().maxCoeff(), kStepMm);
  EXPECT_LT((lesson.rest.bottomRows(10) - pose).cwiseAbs().maxCoeff(), kStepMm);
}

TEST(MakeLesson, LetsAReaderDragTheRigsOwnHandles) {
  BallScene scene;
  const LessonSource source = scene.source(nullptr);
  const Lesson lesson = scene.made(source);
  ASSERT_EQ(lesson.weights.rows(), 10);
  Points pose = scene.document.rig().restPositions();
  const Vec3 pull(-6, 11, 9);
  pose.row(9) += pull.transpose();
  const Points before = scene.live.points(scene.organ());
  scene.live.showPose(pose);
  const Points moved = scene.live.points(scene.organ()) - before;
  EXPECT_LT((moved - lesson.weights.row(9).transpose() * pull.transpose()).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_GT(moved.cwiseAbs().maxCoeff(), 1);
}

TEST(MakeLesson, PlacesHandlesWhereTheOwnAreTooMany) {
  BallScene scene;
  std::vector<document::NewHandle> more;
  for (int i = 0; i < 40; ++i)
    more.push_back({Vec3(55 * std::cos(0.7 * i), 55 * std::sin(0.7 * i), i - 20)});
  scene.undo.perform(document::addHandles(more));
  const Lesson lesson = scene.made(scene.source(nullptr));
  EXPECT_EQ(lesson.weights.rows(), 22);
  EXPECT_EQ(lesson.rest.rows(), lesson.vertexCount() + 22);
  const Eigen::VectorXd sums = lesson.weights.colwise().sum().transpose();
  EXPECT_LE(sums.maxCoeff(), 1 + 1e-9) << "the corners of the box around hold the rest";
  LessonSpec none;
  none.handles = 0;
  EXPECT_EQ(scene.made(scene.source(nullptr), none).weights.rows(), 0);
}

TEST(MakeLesson, RefusesAMotionOfOtherHandles) {
  BallScene scene;
  Points other = scene.document.rig().restPositions();
  other.row(3) += Vec3(9, 0, 0).transpose();
  const LessonSource source =
      scene.source(std::make_shared<viscera::tests::Sway>(other, std::vector<viscera::tests::Swing>{}));
  EXPECT_THROW(scene.made(source), DataError);
}

TEST(MakeLesson, EndsWhenItIsCancelled) {
  BallScene scene;
  scene.progress.cancel();
  EXPECT_THROW(scene.made(scene.source(scene.sway())), Cancelled);
}

/// White at the end of diastole, all rings shorter in systole; a page has it where its author wants it.
TEST(MakeLesson, HasTheStrainOfTheHeartsSegmentsOverTheBeat) {
  SampleScene scene("heartbeat");
  LessonSpec spec = readSpec(R"({"rates": [75], "strain": true, "handles": 0})", "test");
  const Lesson lesson = makeLesson(planLesson(scene.source, spec), scene.source, scene.live, scene.progress);
  ASSERT_EQ(lesson.strain.size(), lesson.courses.size());
  ASSERT_EQ(lesson.sectors.size(), 17U);
  const LessonStrain& strain = lesson.strain.front();
  ASSERT_EQ(strain.percent.rows(), static_cast<Eigen::Index>(strain.fractions.size()));
  EXPECT_TRUE(std::is_sorted(strain.fractions.begin(), strain.fractions.end()));
  const auto basal = strain.percent.col(0), middle = strain.percent.col(6);
  for (const auto& segment : {basal, middle}) {
    EXPECT_LT(segment.minCoeff(), -5);
    EXPECT_LT(segment.cwiseAbs().minCoeff(), 1e-9) << "the reference";
  }
  EXPECT_NE(pageOf(lesson).find("\"strain\":{\"title\""), std::string::npos);
  spec.strain = false;
  EXPECT_FALSE(planLesson(scene.source, spec).strain);
}

} // namespace viscera::lesson
