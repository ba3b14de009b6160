#include "viscera/live/live_stress.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "session_fixture.h"
#include "sway.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/deformation/tetrahedralise.h"
#include "viscera/deformation/witness_gradients.h"
#include "viscera/live/stress_quantity.h"

namespace viscera::live {
namespace {

using StressState = StressStatus::State;
constexpr double kInDegrees = 180 / std::numbers::pi;
constexpr double kBoundAtOnce = std::numeric_limits<double>::infinity();

/// A document with a ball, bound, and its stress.
struct Stressed : tests::BoundSession {
  LiveStress stress;
  StressEvent heard;
  Subscription subscription;

  explicit Stressed(double frameSeconds = kBoundAtOnce, int witnesses = 400,
                    const std::filesystem::path& worker = {})
      : stress(document, registry, live, jobs, options(frameSeconds, witnesses, worker)) {
    subscription = stress.onEvent([this](const StressEvent& event) {
      heard.status |= event.status;
      heard.sampled |= event.sampled;
      heard.moved |= event.moved;
      heard.cycle |= event.cycle;
    });
  }

  static LiveStress::Options options(double frameSeconds, int witnesses,
                                     const std::filesystem::path& worker) {
    LiveStress::Options options;
    options.frameSeconds = frameSeconds;
    options.witnesses.wanted = witnesses;
    options.witnesses.worker = worker;
    return options;
  }

  void waitFor(StressState state) {
    box.runUntil([&] { return stress.status().state == state; });
  }
  void begin() {
    stress.follow(organ());
    waitFor(StressState::ready);
  }
  Points restHandles() const { return document.rig().restPositions(); }
  void move(std::size_t handle, const Vec3& by) {
    Points position(1, 3);
    position = document.pose().row(static_cast<Eigen::Index>(handle)) + by.transpose();
    undo.perform(document::moveHandles({this->handle(handle)}, position));
  }
};

/// One second long.
PosedCycle cycleOf(std::shared_ptr<const sequences::Sequence> sequence) {
  return {1, [sequence = std::move(sequence), pose = Points()](double fraction) mutable -> const Points& {
            sequence->poseAt(fraction, 60, pose);
            return pose;
          }};
}

double largest(const Values& values) {
  return values.cwiseAbs().maxCoeff();
}

TEST(LiveStress, FollowsThePoseWhereTheOrganItselfCannotBeBound) {
  Stressed s;
  s.begin();
  // Some vertices are outside now, so the organ stays at rest.
  Points in(2, 3);
  in << 20, 20, -60, 20, 20, 60;
  s.undo.perform(document::moveRestHandles({s.handle(3), s.handle(7)}, in));
  s.waitFor(StressState::ready);
  ASSERT_EQ(s.live.status(s.organ()).state, BindingStatus::State::failed);
  s.move(8, {0, 0, 25});
  Stressed fresh;
  fresh.undo.reset(s.document.state());
  fresh.begin();
  EXPECT_EQ(s.stress.points(), fresh.stress.points());
  EXPECT_EQ(s.stress.map().rotationalStress, fresh.stress.map().rotationalStress);
  EXPECT_GT(s.stress.statistics().max, 1e-3);
}

TEST(LiveStress, FillsTheOrganAndIsNothingAtRest) {
  Stressed s;
  EXPECT_EQ(s.stress.status().state, StressState::off);
  s.begin();
  ASSERT_TRUE(s.stress.mesh());
  EXPECT_TRUE(s.heard.sampled && s.heard.moved && s.heard.status);
  EXPECT_EQ(s.stress.map().rotationalStress.size(), s.stress.mesh()->points.rows());
  EXPECT_LT(s.stress.statistics().max, 1e-9);
  EXPECT_LT((s.stress.points() - s.stress.mesh()->points).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_TRUE(s.stress.status().closedForm);
}

TEST(LiveStress, IsTheDirectEvaluationInEveryPoseThatIsShown) {
  Stressed s;
  s.begin();
  const auto system = s.registry.find("s-celestial");
  coordinates::HandleSet handles;
  handles.positions = s.restHandles();
  Progress progress;
  const auto direct = deformation::bindWitnesses(*system, handles, s.stress.mesh()->points,
                                                 {s.document.system().parameters, {}}, progress);
  deformation::StressMap expected;
  for (int step = 0; step < 3; ++step) {
    s.heard = {};
    s.move(static_cast<std::size_t>(step), Vec3(8, -5, 11));
    EXPECT_TRUE(s.heard.moved);
    direct->evaluate(s.document.pose(), expected);
    EXPECT_EQ(s.stress.map().rotationalStress, expected.rotationalStress);
    EXPECT_EQ(s.stress.map().volumeRatio, expected.volumeRatio);
    EXPECT_EQ(s.stress.statistics().max,
              expected.rotationalStress.head(s.stress.mesh()->witnesses).maxCoeff());
    EXPECT_GT(s.stress.statistics().max, 0.01);
  }
  // A sequence's pose is shown without the document knowing.
  Points pose = s.restHandles();
  pose.row(4).y() += 17;
  s.live.showPose(pose);
  direct->evaluate(pose, expected);
  EXPECT_EQ(s.stress.map().rotationalStress, expected.rotationalStress);
}

TEST(LiveStress, IsNotComputedAnewWhereOrgansOnlyComeOrLookOtherwise) {
  Stressed s;
  s.begin();
  s.move(0, Vec3(8, -5, 11));
  const std::uint64_t revision = s.stress.frame().revision;
  s.heard = {};
  document::OrganLook look;
  look.opacity = 0.5;
  s.undo.perform(document::setOrganLook(s.organ(), look));
  s.undo.perform(document::addOrgans({tests::ball("Second", 9, 2, {12, 0, 0})}));
  EXPECT_FALSE(s.heard.moved);
  EXPECT_EQ(s.stress.frame().revision, revision);
  // Who comes back to the organ finds the map of the pose that there is then.
  s.stress.follow({});
  s.move(0, Vec3(3, 0, 0));
  s.stress.follow(s.organ());
  EXPECT_TRUE(s.heard.moved);
  EXPECT_NE(s.stress.frame().revision, revision);
}

TEST(LiveStress, OfARigidMotionIsZero) {
  Stressed s;
  s.begin();
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  const Points pose = (s.restHandles() * turn.transpose()).rowwise() + Eigen::RowVector3d(30, -4, 9);
  s.live.showPose(pose);
  EXPECT_LT(largest(s.stress.map().rotationalStress), 1e-9);
  EXPECT_LT(largest(s.stress.map().volumeRatio.array() - 1), 1e-9);
  const Points expected =
      (s.stress.mesh()->points * turn.transpose()).rowwise() + Eigen::RowVector3d(30, -4, 9);
  EXPECT_LT((s.stress.points() - expected).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(LiveStress, BindsAnewWhenRestHandlesOrTheSystemChange) {
  Stressed s;
  s.begin();
  s.move(0, Vec3(10, 0, 0));
  const auto before = s.stress.gradients();
  const Values mapBefore = s.stress.map().rotationalStress;
  s.undo.perform(document::moveRestHandles({s.handle(9)}, tests::row(45, 3, -1)));
  s.waitFor(StressState::ready);
  EXPECT_NE(s.stress.gradients(), before);
  EXPECT_NE(s.stress.map().rotationalStress, mapBefore);
  const auto second = s.stress.gradients();
  s.undo.perform(document::setSystem({"t-celestial", {}}));
  EXPECT_NE(s.stress.gradients(), second);
  // Back by undo: the same numbers to the last bit.
  s.undo.undo();
  s.undo.undo();
  EXPECT_EQ(s.stress.map().rotationalStress, mapBefore);
}

TEST(LiveStress, BindsOnTheQueueWhenThatTakesLongAndShowsNoWrongMapMeanwhile) {
  Stressed s(0);
  s.stress.follow(s.organ());
  s.box.runUntil([&] { return s.stress.status().state == StressState::binding; });
  EXPECT_EQ(s.stress.points().rows(), 0);
  s.waitFor(StressState::ready);
  s.move(0, Vec3(10, 0, 0));
  const Values map = s.stress.map().rotationalStress;
  Stressed atOnce;
  atOnce.begin();
  atOnce.move(0, Vec3(10, 0, 0));
  EXPECT_EQ(atOnce.stress.map().rotationalStress, map) << "the way there does not matter";
}

TEST(LiveStress, CanBeCancelledAndGoesOnWhenAsked) {
  Stressed s;
  s.stress.follow(s.organ());
  s.jobs.cancelAll();
  s.waitFor(StressState::cancelled);
  s.undo.perform(document::moveRestHandles({s.handle(9)}, tests::row(45, 3, -1)));
  EXPECT_EQ(s.stress.status().state, StressState::cancelled) << "no surprise work after a cancellation";
  s.stress.retry();
  s.waitFor(StressState::ready);
  EXPECT_GT(s.stress.mesh()->witnesses, 0);
}

TEST(LiveStress, OutlivesAWorkerThatIsKilledAndTriesAgainWhenAsked) {
  const tests::TemporaryFolder folder;
  // TetGen's place: killed as by the system that is short of memory, until the file beside it is there.
  const std::filesystem::path worker =
      folder.put("worker", "#!/bin/sh\n[ -e \"$(dirname \"$0\")/well\" ] || kill -KILL $$\nexec \"" +
                               deformation::installedTetgenWorker().string() + "\"\n");
  std::filesystem::permissions(worker, std::filesystem::perms::owner_all);
  Stressed s(kBoundAtOnce, 400, worker);
  const document::DocumentState before = s.document.state();
  s.begin();
  EXPECT_THAT(inEnglish(s.stress.status().remarks), testing::Contains(testing::HasSubstr("it crashed")));
  EXPECT_GT(s.stress.mesh()->witnesses, 0) << "the grid stands in";
  EXPECT_TRUE(identical(s.document.state(), before));
  folder.put("well", "");
  s.stress.setWanted(800);
  s.waitFor(StressState::ready);
  EXPECT_THAT(inEnglish(s.stress.status().remarks),
              testing::Not(testing::Contains(testing::HasSubstr("it crashed"))));
}

TEST(LiveStress, KeepsItsResultWhileItIsOffAndTakesAnotherNumberOfWitnesses) {
  Stressed s;
  s.begin();
  const auto mesh = s.stress.mesh();
  s.stress.follow({});
  EXPECT_EQ(s.stress.status().state, StressState::off);
  s.move(0, Vec3(10, 0, 0));
  s.stress.follow(s.organ());
  EXPECT_EQ(s.stress.status().state, StressState::ready);
  EXPECT_EQ(s.stress.mesh(), mesh);
  EXPECT_GT(s.stress.statistics().max, 0.01);
  s.stress.setWanted(800);
  s.waitFor(StressState::ready);
  EXPECT_GT(s.stress.mesh()->witnesses, mesh->witnesses);
  EXPECT_THROW(s.stress.setWanted(10), UsageError);
}

TEST(LiveStress, SaysWhyThereIsNoMapAndForgetsAnOrganThatIsGone) {
  Stressed s;
  s.begin();
  std::vector<document::HandleId> most;
  for (std::size_t i = 2; i < s.document.rig().handles.size(); ++i)
    most.push_back(s.handle(i));
  s.undo.perform(document::removeHandles(most));
  EXPECT_EQ(s.stress.status().state, StressState::failed);
  EXPECT_THAT(s.stress.status().message.english(), testing::HasSubstr("handles"));
  EXPECT_EQ(s.stress.map().rotationalStress.size(), 0);
  s.undo.undo();
  EXPECT_EQ(s.stress.status().state, StressState::ready);
  s.undo.perform(document::removeOrgans({s.organ()}));
  EXPECT_EQ(s.stress.status().state, StressState::off);
}

TEST(LiveStress, LeavesOutTheOrgansCavities) {
  Stressed s(kBoundAtOnce, 2000);
  s.begin();
  const auto whole = s.stress.mesh();
  document::NewOrgan cavity = tests::ball("Cavity", 15);
  cavity.organ.parent = s.organ();
  s.undo.perform(document::addOrgans({cavity}));
  s.waitFor(StressState::ready);
  EXPECT_LT(s.stress.mesh()->witnesses, whole->witnesses);
  EXPECT_GT(s.stress.mesh()->witnesses, whole->witnesses / 2);
  const double volume =
      deformation::tetrahedronVolumes(s.stress.mesh()->points, s.stress.mesh()->tetrahedra).sum();
  const double before = deformation::tetrahedronVolumes(whole->points, whole->tetrahedra).sum();
  EXPECT_NEAR(before - volume, 4.0 / 3 * std::numbers::pi * 15 * 15 * 15, 0.1 * (before - volume));
  s.undo.undo();
  s.waitFor(StressState::ready);
  EXPECT_EQ(s.stress.mesh()->points, whole->points);
}

TEST(LiveStress, PeakIsTheLargestOverTheFrames) {
  Stressed s;
  s.begin();
  const auto sway = std::make_shared<viscera::tests::Sway>(
      s.restHandles(),
      std::vector<viscera::tests::Swing>{{0, Vec3(20, 0, 0)}, {9, Vec3(0, 0, 15), std::numbers::pi / 2}});
  s.stress.findCycle(cycleOf(sway), CycleParts::curveAndPeak);
  s.box.runUntil([&] { return s.stress.cycle() != nullptr; });
  const CycleStress& cycle = *s.stress.cycle();
  const deformation::StressMap& peak = *cycle.peak;
  EXPECT_EQ(cycle.periodSeconds, 1);
  Values stress = Values::Zero(peak.rotationalStress.size());
  Values stretch = stress;
  double worst = 0;
  deformation::StressMap map;
  Points pose;
  const auto frames = cycle.samples.size();
  const std::vector<StressSample> curve = cycle.samples;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    sway->poseAt(static_cast<double>(frame) / static_cast<double>(frames), 60, pose);
    s.stress.gradients()->evaluate(pose, map);
    stress = stress.cwiseMax(map.rotationalStress);
    stretch = stretch.cwiseMax(map.stretchMax);
    const auto statistics = deformation::statisticsOf(map, s.stress.mesh()->witnesses);
    EXPECT_NEAR(cycle.samples[frame].statistics.max, statistics.max, 1e-12);
    worst = std::max(worst, statistics.max);
  }
  EXPECT_GE(frames, 50u);
  EXPECT_LT(largest(peak.rotationalStress - stress), 1e-12);
  EXPECT_LT(largest(peak.stretchMax - stretch), 1e-12);
  EXPECT_GT(worst, 0.01);
  EXPECT_EQ(cycle.worst()->statistics.max, worst);
  // The curve alone has the same samples.
  s.stress.dropCycle();
  s.stress.findCycle(cycleOf(sway), CycleParts::curve);
  s.box.runUntil([&] { return s.stress.cycle() != nullptr; });
  EXPECT_FALSE(s.stress.cycle()->peak);
  EXPECT_EQ(s.stress.cycle()->samples[frames / 3].statistics.percentile95,
            curve[frames / 3].statistics.percentile95);
  // Other handles: the maximum is not theirs.
  s.undo.perform(document::moveRestHandles({s.handle(9)}, tests::row(45, 3, -1)));
  EXPECT_EQ(s.stress.cycle(), nullptr);
}

TEST(LiveStress, OfAnOrganThatDoesNotBendIsRefusedInWordsUntilItBends) {
  Stressed s;
  s.begin();
  s.move(9, {20, 5, 0});
  const double bent = s.stress.statistics().max;
  EXPECT_GT(bent, 0);
  s.undo.perform(document::setMobility({s.organ()}, document::Mobility::rigid));
  EXPECT_EQ(s.stress.status().state, StressState::failed);
  EXPECT_THAT(s.stress.status().message.english(), testing::HasSubstr("does not bend"));
  s.undo.undo();
  s.waitFor(StressState::ready);
  EXPECT_EQ(s.stress.statistics().max, bent);
}

TEST(LiveStress, ThePointsOfACycleHaveCurvesOfTheirOwn) {
  Stressed s;
  s.begin();
  const auto sequence = std::make_shared<tests::Sway>(
      s.restHandles(), std::vector<tests::Swing>{{0, Vec3(20, 0, 0)}, {9, Vec3(0, 0, 15), 1.1}});
  s.stress.findCycle(cycleOf(sequence), CycleParts::curveAndPeak);
  s.box.runUntil([&] { return s.stress.cycle() != nullptr; });
  const CycleStress& cycle = *s.stress.cycle();
  ASSERT_EQ(cycle.poses.size(), cycle.samples.size());
  const Eigen::Index point = 17;
  const std::vector<double> curve =
      curveAt(*s.stress.gradients(), point, cycle, StressQuantity::rotationalStress);
  ASSERT_EQ(curve.size(), cycle.samples.size());
  double worst = 0;
  for (std::size_t i = 0; i < curve.size(); i += 9) {
    Points pose;
    sequence->poseAt(cycle.samples[i].seconds, 60, pose);
    s.live.showPose(pose);
    EXPECT_NEAR(curve[i], kInDegrees * s.stress.map().rotationalStress[point], 1e-9);
  }
  for (const double value : curve)
    worst = std::max(worst, value);
  EXPECT_NEAR(worst, kInDegrees * cycle.peak->rotationalStress[point], 1e-9);
}

TEST(StressFrame, TheDifferenceOfTwoPosesIsThatOfTheirMaps) {
  Stressed a, b;
  a.begin();
  b.begin();
  a.move(9, {20, 5, 0});
  b.move(9, {-8, 0, 4});
  const auto difference = differenceOf(a.stress.frame(), b.stress.frame(), StressQuantity::volumeRatio);
  ASSERT_TRUE(difference);
  EXPECT_EQ(*difference, Values(a.stress.map().volumeRatio - b.stress.map().volumeRatio));
  EXPECT_GT(difference->cwiseAbs().maxCoeff(), 0.01);
  Stressed other(kBoundAtOnce, 600);
  other.begin();
  EXPECT_FALSE(differenceOf(a.stress.frame(), other.stress.frame(), StressQuantity::volumeRatio))
      << "other witness points";
  EXPECT_FALSE(differenceOf(a.stress.frame(), StressFrame(), StressQuantity::volumeRatio));
}

TEST(LiveStress, TellsWhyACycleCouldNotBeComputed) {
  Stressed s;
  s.begin();
  const PosedCycle broken{1, [](double) -> const Points& { throw DataError("the sequence has no poses"); }};
  s.stress.findCycle(broken, CycleParts::curve);
  EXPECT_TRUE(s.stress.findingCycle());
  s.box.runUntil([&] { return !s.stress.findingCycle(); });
  EXPECT_EQ(s.stress.cycle(), nullptr);
  EXPECT_THAT(s.stress.cycleMessage().english(), testing::HasSubstr("sequence has no poses"));
  s.stress.dropCycle();
  EXPECT_EQ(s.stress.cycleMessage().english(), "");
}

TEST(LiveStress, PeakIsOfTheCycleThatWasAskedForLast) {
  Stressed s;
  s.begin();
  const auto find = [&](double mm) {
    const auto sway = std::make_shared<viscera::tests::Sway>(
        s.restHandles(), std::vector<viscera::tests::Swing>{{0, Vec3(mm, 0, 0)}});
    s.stress.findCycle(cycleOf(sway), CycleParts::curveAndPeak);
  };
  const auto found = [&] {
    s.box.runUntil([&] { return s.stress.cycle() != nullptr; });
    return largest(s.stress.cycle()->peak->rotationalStress);
  };
  find(20);
  const double far = found();
  s.stress.dropCycle();
  find(10);
  EXPECT_EQ(s.stress.cycle(), nullptr) << "that of the cycle before";
  EXPECT_LT(found(), far);
  s.stress.dropCycle();
  find(10);
  find(20);
  EXPECT_EQ(found(), far);
  s.stress.dropCycle();
  EXPECT_EQ(s.stress.cycle(), nullptr);
}

TEST(StressQuantity, IsNotANumberWhereTheTissueIsFoldedExceptForFoldingItself) {
  deformation::StressMap map;
  map.rotationalStress = Eigen::Vector2d(std::numbers::pi / 6, 1);
  map.volumeRatio = Eigen::Vector2d(1.2, -0.1);
  map.stretchMax = Eigen::Vector2d(1.5, 2);
  map.stretchMin = Eigen::Vector2d(0.5, 0.1);
  Values values;
  quantityOf(map, StressQuantity::rotationalStress, values);
  EXPECT_NEAR(values[0], 30, 1e-12);
  EXPECT_TRUE(std::isnan(values[1]));
  quantityOf(map, StressQuantity::folded, values);
  EXPECT_EQ(values, Values(Eigen::Vector2d(0, 1)));
  for (const auto& description : stressQuantities())
    EXPECT_EQ(stressQuantityFromId(description.id), description.quantity);
}

TEST(StressQuantity, SummaryAgreesWithTheStatisticsOfTheMap) {
  Stressed s;
  s.begin();
  s.move(0, Vec3(14, -5, 3));
  Values values;
  quantityOf(s.stress.map(), StressQuantity::rotationalStress, values);
  const QuantitySummary summary = summaryOf(values, s.stress.mesh()->witnesses);
  const deformation::StressStatistics& statistics = s.stress.statistics();
  const double degrees = 180 / std::numbers::pi;
  ASSERT_EQ(statistics.folded, 0);
  EXPECT_NEAR(summary.min, degrees * statistics.min, 1e-12);
  EXPECT_NEAR(summary.mean, degrees * statistics.mean, 1e-10);
  EXPECT_NEAR(summary.percentile95, degrees * statistics.percentile95, 1e-12);
  EXPECT_NEAR(summary.max, degrees * statistics.max, 1e-12);
}

} // namespace
} // namespace viscera::live
