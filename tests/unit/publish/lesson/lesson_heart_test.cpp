#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

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
            mesh.triangles.rows() + scene.source.tissue->septum()->triangles.rows());
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

/// The last part of the walls is the closed surface that fills the fold between the atria.
TEST(LessonOfAnOpenedHeart, HasTheSeptumBetweenTheAtria) {
  HeartScene scene;
  const Lesson lesson = scene.made();
  ASSERT_TRUE(lesson.tissue && scene.source.tissue->septum());
  const LessonTissue& tissue = *lesson.tissue;
  const geometry::TriangleMesh& septum = *scene.source.tissue->septum();
  const Eigen::Index first = tissue.inner.rest.rows() - septum.points.rows();
  ASSERT_GE(first, 0);
  EXPECT_EQ(tissue.colors.rows(), tissue.inner.rest.rows());
  EXPECT_LT((tissue.inner.rest.bottomRows(septum.points.rows()) - septum.points).cwiseAbs().maxCoeff(), 1e-9);
  const Triangles triangles = tissue.triangles.bottomRows(septum.triangles.rows());
  EXPECT_EQ(triangles.minCoeff(), lesson.vertexCount() + first);
  EXPECT_EQ(triangles.maxCoeff() + 1, lesson.vertexCount() + tissue.inner.rest.rows());
}

/// Planes of resources/scripts/draw_heart_cuts.py by their normals and their places along them, in parts of
/// the ball around the heart.
const std::vector<std::pair<Vec3, double>> kLessonCuts = {
    {{-0.2900, 0.3687, -0.8831}, 0.2599},  {{-0.6618, -0.7449, 0.0850}, -0.1092},
    {{-0.7691, -0.4429, -0.4608}, 0.0602}, {{-0.6388, 0.5490, 0.5390}, -0.1352},
    {{-0.6388, 0.5490, 0.5390}, -0.4000},  {{-0.6388, 0.5490, 0.5390}, -0.6025},
    {{0.7679, 0.4374, 0.4680}, -0.0611},   {{-1.0000, 0.0000, 0.0000}, 0.3184},
    {{-0.5239, -0.7976, 0.2990}, 0.1622}};

/// A name of the page stands at a vertex; what a cut leaves of it is drawn as walls, so that these have to be
/// where the vertex is, at every instant. A valve is drawn as its ring.
TEST(LessonOfAnOpenedHeart, HasItsNamesOnTheWallsInEveryCut) {
  constexpr double kOnWallMm = 6;
  HeartScene scene;
  const Lesson lesson = scene.made();
  ASSERT_TRUE(lesson.tissue);
  const Bounds bounds = boundsOf(lesson.rest.topRows(lesson.vertexCount()));
  std::set<std::string> named;
  for (const double fraction : {0.0, 0.15, 0.35, 0.6, 0.85}) {
    const Points vertices = pagePoints(lesson, 1, fraction);
    const Points inner = shownParts(lesson.tissue->inner, vertices, lesson);
    const LessonSurface& outer = lesson.surfaces[lesson.tissue->surface];
    Points walls(inner.rows() + outer.vertexCount, 3);
    walls << inner, vertices.middleRows(outer.firstVertex, outer.vertexCount);
    for (const auto& [normal, offset] : kLessonCuts) {
      const Vec3 origin = bounds.center() + offset * bounds.diagonal() / 2 * normal;
      for (std::size_t surface = 0; surface < lesson.surfaces.size(); ++surface)
        for (std::size_t i = 0; i < lesson.surfaces[surface].labels.size(); ++i) {
          const auto& label = lesson.plan.surfaces[surface].labels[i];
          const Vec3 at = vertices.row(lesson.surfaces[surface].labels[i]).transpose();
          if (label.ringMm > 0 || (at - origin).dot(normal) < 0)
            continue;
          named.insert(label.text);
          EXPECT_LT((walls.rowwise() - at.transpose()).rowwise().norm().minCoeff(), kOnWallMm)
              << label.text << " at " << fraction;
        }
    }
  }
  for (const char* name : {"Terminal crest", "Oval fossa", "Opening of the coronary sinus"})
    EXPECT_EQ(named.count(name), 1u) << name;
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
