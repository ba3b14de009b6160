#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "lesson_scene.h"

#include "page_json.h"
#include "viscera/circulation/signs.h"
#include "viscera/heart/beating_heart.h"
#include "viscera/live/heart_tissue.h"

namespace viscera::lesson {
namespace {

/// Of the walls' inner vertices, which four others carry: the worst of the coarse heart is 1.0 mm off.
constexpr double kMostMm = 1.2;

/// A lesson of the coarse heart with its walls and its conduction system.
struct HeartScene : SampleScene {
  HeartScene() : SampleScene("heartbeat") {
    source.tissue = live::makeHeartTissue(live::sampleHeartIn(source.state).value(),
                                          viscera::tests::cachedLibrary(), progress);
    source.conduction = true;
  }
  LessonSpec spec() const {
    LessonSpec few;
    few.rates = {60, 75, 120};
    return few;
  }
  Lesson made() { return makeLesson(planLesson(source, spec()), source, live, progress); }
};

Points shownParts(const CarriedParts& parts, const Points& vertices, const Lesson& lesson) {
  Points points = parts.rest;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    for (int k = 0; k < CarriedParts::kCarriers; ++k) {
      const Eigen::Index vertex = parts.vertices(i, k);
      points.row(i) += parts.weights(i, k) * (vertices.row(vertex) - lesson.rest.row(vertex));
    }
  return points;
}

} // namespace

TEST(LessonOfAnOpenedHeart, HasItsWallsWhereTheWindowHasThem) {
  HeartScene scene;
  const Lesson lesson = scene.made();
  ASSERT_TRUE(lesson.tissue);
  const LessonTissue& tissue = *lesson.tissue;
  const auto heart = live::sampleHeartIn(scene.source.state).value();
  const geometry::TriangleMesh& mesh = *scene.source.tissue->mesh();
  EXPECT_EQ(lesson.surfaces[tissue.surface].triangleCount - static_cast<Eigen::Index>(tissue.left.size()) +
                tissue.triangles.rows(),
            mesh.triangles.rows());
  EXPECT_EQ(tissue.chambers.size(), heart.cavities.size());
  std::map<std::array<double, 3>, Eigen::Index> inner;
  for (Eigen::Index i = 0; i < tissue.inner.rest.rows(); ++i)
    inner[{tissue.inner.rest(i, 0), tissue.inner.rest(i, 1), tissue.inner.rest(i, 2)}] = i;
  for (std::size_t rate = 0; rate < lesson.plan.rates.size(); ++rate)
    for (const double fraction : {0.093, 0.3571, 0.7129}) {
      organPoints(lesson.plan, scene.source, scene.live, rate, fraction);
      Points exact;
      scene.source.tissue->at(heart, scene.live, exact);
      const Points shown = shownParts(tissue.inner, pagePoints(lesson, rate, fraction), lesson);
      double worst = 0;
      for (Eigen::Index i = 0; i < mesh.points.rows(); ++i)
        if (const auto found = inner.find({mesh.points(i, 0), mesh.points(i, 1), mesh.points(i, 2)});
            found != inner.end())
          worst = std::max(worst, (shown.row(found->second) - exact.row(i)).norm());
      EXPECT_LT(worst, kMostMm) << "rate " << rate << ", " << fraction;
    }
}

TEST(LessonOfAnOpenedHeart, HasPartsWhoseWeightsAreOneTogether) {
  HeartScene scene;
  const Lesson lesson = scene.made();
  ASSERT_TRUE(lesson.tissue && lesson.conduction);
  for (const CarriedParts* parts : {&lesson.tissue->inner, &lesson.conduction->points}) {
    EXPECT_LT((parts->weights.rowwise().sum().array() - 1).abs().maxCoeff(), 1e-12);
    EXPECT_GE(parts->vertices.minCoeff(), 0);
    EXPECT_LT(parts->vertices.maxCoeff(), lesson.vertexCount());
  }
}

TEST(LessonOfAnOpenedHeart, HasFourChambersInItsPlaneAtFirst) {
  HeartScene scene;
  const LessonPlan plan = planLesson(scene.source, {});
  ASSERT_TRUE(plan.cut);
  EXPECT_FALSE(plan.cut->on);
  const auto frame = scene.source.sequence->heart()->frame();
  ASSERT_TRUE(frame);
  EXPECT_NEAR(plan.cut->normal.dot(frame->towardsApex()), 0, 1e-9);
  EXPECT_NEAR(plan.cut->normal.dot(frame->towardsRight()), 0, 1e-9);
  scene.source.cut = {true, Vec3::UnitX(), 0, true};
  const LessonPlan own = planLesson(scene.source, {});
  ASSERT_TRUE(own.cut);
  EXPECT_TRUE(own.cut->on && own.cut->blood) << "as the session has it";
  EXPECT_EQ(own.cut->normal, Vec3::UnitX());
}

TEST(LessonOfAnOpenedHeart, IsInThePageOnlyWhereItIsAskedFor) {
  HeartScene scene;
  ArrayPacker with, without;
  const auto json = nlohmann::ordered_json::parse(pageJson(scene.made(), with));
  EXPECT_EQ(json["tissue"]["chambers"].size(), 4u);
  EXPECT_EQ(json["conduction"]["beats"].size(), 3u);
  EXPECT_EQ(json["arrays"]["carriers"]["count"].get<int>() / CarriedParts::kCarriers,
            json["arrays"]["inner"]["count"].get<int>() / 3);
  scene.source.tissue = nullptr;
  scene.source.conduction = false;
  const auto plain = nlohmann::ordered_json::parse(pageJson(scene.made(), without));
  EXPECT_FALSE(plain.contains("tissue") || plain.contains("conduction"));
  EXPECT_FALSE(plain["arrays"].contains("inner"));
}

TEST(LessonOfTheConductionSystem, IsLitAsTheBeatExcitesIt) {
  HeartScene scene;
  scene.source.tissue = nullptr;
  const Lesson lesson = scene.made();
  ASSERT_TRUE(lesson.conduction);
  EXPECT_GT(lesson.conduction->ways.size(), 20u);
  for (std::size_t rate = 0; rate < lesson.plan.rates.size(); ++rate) {
    const LessonExcitation& beat = lesson.conduction->beats[rate];
    for (const double fraction : {0.05, 0.21, 0.44, 0.86, 0.95}) {
      const double perMinute = lesson.plan.rates[rate];
      const auto clock = heart::clockAt(*scene.source.sequence, fraction * 60 / perMinute, perMinute).value();
      circulation::Parameters parameters;
      parameters.rate = clock.ratePerMinute;
      parameters.conduction = clock.conduction;
      const double since = fraction - beat.begins - std::floor(fraction - beat.begins);
      std::size_t next = 1;
      while (next + 1 < beat.marks.size() && beat.marks[next][0] <= since)
        ++next;
      const auto [from, low] = beat.marks[next - 1];
      const auto [to, high] = beat.marks[next];
      EXPECT_NEAR(low + (high - low) * (since - from) / (to - from),
                  circulation::excitationMs(parameters, clock.seconds), 0.01)
          << perMinute << " a minute, " << fraction;
    }
    EXPECT_EQ(static_cast<Eigen::Index>(beat.ecgMv.size()), kEcgSamples);
    EXPECT_GT(*std::max_element(beat.ecgMv.begin(), beat.ecgMv.end()), 0.5) << "R";
  }
}

} // namespace viscera::lesson
