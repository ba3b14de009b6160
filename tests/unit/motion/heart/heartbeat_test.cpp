#include "viscera/heart/heartbeat.h"

#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include <gtest/gtest.h>

#include "simple_heart.h"
#include "viscera/core/error.h"
#include "viscera/heart/cardiac_cycle.h"
#include "viscera/heart/course_heartbeat.h"
#include "viscera/heart/scaled_sequence.h"
#include "viscera/sequences/keyframes.h"

namespace viscera::heart {
namespace {

/// A stand-in for measured meshes: volumes from the handles of the walls, nonlinear, coupled, and not quite
/// what the motion's formulas expect.
class WallVolumes {
public:
  explicit WallVolumes(const HeartRig& rig) : rig_(rig) {}

  CavityVolumes operator()(const Points& pose) const {
    ++calls;
    return {130.5 * std::pow(meanRatio(HeartRole::leftEndocardium, pose), 2.3),
            138 * (0.2 + 0.8 * std::pow(meanRatio(HeartRole::rightFreeWall, pose), 3.1)) *
                std::pow(meanRatio(HeartRole::leftEndocardium, pose), 0.1)};
  }

  mutable int calls = 0;

private:
  double meanRatio(HeartRole role, const Points& pose) const {
    double before = 0;
    double after = 0;
    for (const int row : rig_.handlesOf(role)) {
      before += rig_.handles[static_cast<std::size_t>(row)].place.rho;
      after += rig_.anatomy.frame.cylindrical(pose.row(row).transpose()).rho;
    }
    return after / before;
  }

  const HeartRig& rig_;
};

class CavityHeartbeatTest : public ::testing::Test {
protected:
  CavityFit fitWith(sequences::PoseCompensation compensation) const {
    return {motion_, std::move(compensation), std::cref(volumes_)};
  }

  HeartMotion motion_{makeHeartRig(test::simpleHeart())};
  CardiacCycle cycle_;
  WallVolumes volumes_{motion_.rig()};
  CavityHeartbeat heartbeat_{fitWith({}), cycle_};
  Points pose_;
};

TEST_F(CavityHeartbeatTest, IsAHeartbeatAtEverySizeAndRecordedPosesOfItAreNone) {
  EXPECT_NE(heartbeat_.heart(), nullptr);
  const auto same = std::make_shared<CavityHeartbeat>(fitWith({}), cycle_);
  EXPECT_NE(ScaledSequence(same, 1.2).heart(), nullptr);
  sequences::KeyframedSequence::Track track;
  track.restHandles = heartbeat_.restHandles();
  heartbeat_.poseAt(0.2, 75, pose_);
  track.keys = {{0, track.restHandles}, {0.5, pose_}};
  const sequences::KeyframedSequence recorded(track);
  EXPECT_EQ(recorded.heart(), nullptr);
  EXPECT_EQ(valvesAt(recorded, 0.2, 75), std::nullopt);
  EXPECT_TRUE(heartbeat_.keys().empty()) << "its poses are computed";
}

TEST_F(CavityHeartbeatTest, TellsItsBeatItsValvesAndWhereItsCavitiesAre) {
  const BeatingHeart& heart = *heartbeat_.heart();
  ASSERT_TRUE(heart.textbookBeat(75) && heart.frame());
  EXPECT_EQ(heart.textbookBeat(75)->left().outletOpens, cycle_.beat(75).left().outletOpens);
  EXPECT_EQ(heart.frame()->origin(), motion_.rig().anatomy.frame.origin());
  EXPECT_EQ(valvesAt(heartbeat_, 0.3, 75), textbookValves(cycle_.beat(75), 0.3));
  const CardiacBeat beat = cycle_.beat(75);
  const auto clock = clockAt(heartbeat_, beat.left().inletShuts + 0.1, 75);
  ASSERT_TRUE(clock);
  EXPECT_NEAR(clock->seconds, 0.1, 1e-12) << "after the ventricles begin to contract";
  EXPECT_EQ(clock->conduction, beat.times().atrialSystole);
  EXPECT_NEAR(clock->ratePerMinute, 75, 1e-9);
}

TEST_F(CavityHeartbeatTest, OfAnotherSizeHasTheSameBeatAndValvesAndAFrameOfThatSize) {
  constexpr double kSize = 1.5, kAllowed = 1e-12;
  const auto same = std::make_shared<CavityHeartbeat>(fitWith({}), cycle_);
  const ScaledSequence scaled(same, kSize);
  const BeatingHeart& heart = *scaled.heart();
  EXPECT_EQ(heart.textbookBeat(90)->left().inletShuts, cycle_.beat(90).left().inletShuts);
  const HeartFrame standard = *same->frame(), frame = *heart.frame();
  const Vec3 place(3, -20, 41);
  EXPECT_LT((frame.toLocal(kSize * place) - kSize * standard.toLocal(place)).norm(), 100 * kAllowed);
  const ValveInstants valves = *heart.valves(0.3, 90), small = *same->valves(0.3, 90);
  EXPECT_GT(small[1].areaMm2, 0) << "the aortic valve is open";
  for (std::size_t i = 0; i < kHeartValves; ++i) {
    EXPECT_NEAR(valves[i].areaMm2, kSize * kSize * small[i].areaMm2, kAllowed * valves[i].areaMm2);
    EXPECT_NEAR(valves[i].flowMlPerS, kSize * kSize * kSize * small[i].flowMlPerS,
                kAllowed * std::abs(valves[i].flowMlPerS));
  }
}

TEST_F(CavityHeartbeatTest, ByACirculationHasItsValvesAndNoEventsOfTheTextbook) {
  HeartCourse course{"Course", 0.8, {}, {{"beat", 0, 1}}};
  for (int i = 0; i < 8; ++i)
    course.instants.push_back(heartInstant(cycle_, cycle_.at(0.1 * i, 75)));
  Progress quiet;
  const CourseHeartbeat without(fitWith({}), course, quiet);
  ASSERT_NE(without.heart(), nullptr);
  EXPECT_FALSE(without.heart()->textbookBeat(75));
  EXPECT_FALSE(without.heart()->valves(0.2, 75)) << "the course does not tell them";
  EXPECT_EQ(without.heart()->frame()->origin(), motion_.rig().anatomy.frame.origin());
  for (int i = 0; i < 8; ++i)
    course.valves.push_back(textbookValves(cycle_.beat(75), 0.1 * i));
  const CourseHeartbeat with(without, course);
  EXPECT_EQ(valvesAt(with, 0.2, 75), course.valvesAt(0.25));
  EXPECT_FALSE(clockAt(with, 0.2, 75)) << "the course does not tell it";
  course.begins = BeatClock{-0.2, 0.14, 75};
  EXPECT_EQ(clockAt(CourseHeartbeat(without, course), 0.4, 75), (BeatClock{-0.2 + 0.5 * 0.8, 0.14, 75}));
}

TEST_F(CavityHeartbeatTest, CavitiesHoldWhatTheCycleSaysAtAnyTimeAndRate) {
  double left = 0;
  double right = 0;
  for (const double rate : {20.0, 50.0, 75.0, 100.0, 150.0, 220.0}) {
    for (int k = 0; k < 331; ++k) {
      const double seconds = k / 331.0 * 60 / rate;
      heartbeat_.poseAt(seconds, rate, pose_);
      const CavityVolumes measured = volumes_(pose_);
      const CavityVolumes wanted = cycle_.at(seconds, rate).volumes;
      left = std::max(left, std::abs(measured.leftMl - wanted.leftMl));
      right = std::max(right, std::abs(measured.rightMl - wanted.rightMl));
    }
  }
  EXPECT_LT(left, 1e-4);
  EXPECT_LT(right, 1e-4);
}

TEST_F(CavityHeartbeatTest, APoseNeedsFewMeasurements) {
  volumes_.calls = 0;
  for (int k = 0; k < 96; ++k)
    heartbeat_.poseAt(k * 0.8 / 96, 75, pose_);
  EXPECT_LT(volumes_.calls, 96 * 5);
}

TEST_F(CavityHeartbeatTest, RepeatsWithTheBeat) {
  Points later;
  for (const double seconds : {0.0, 0.21, 0.55}) {
    heartbeat_.poseAt(seconds, 75, pose_);
    heartbeat_.poseAt(seconds + 3 * 0.8, 75, later);
    EXPECT_LT((pose_ - later).cwiseAbs().maxCoeff(), 1e-6);
  }
}

TEST_F(CavityHeartbeatTest, MovesWithoutJumps) {
  Points next;
  heartbeat_.poseAt(0, 75, pose_);
  for (int k = 1; k <= 800; ++k) {
    heartbeat_.poseAt(k * 1e-3, 75, next);
    EXPECT_LT((next - pose_).rowwise().norm().maxCoeff(), 0.6) << k;
    pose_ = next;
  }
}

TEST_F(CavityHeartbeatTest, DescribesItselfAsASequence) {
  const sequences::Sequence& sequence = heartbeat_;
  EXPECT_EQ(sequence.id(), "heartbeat");
  EXPECT_EQ(sequence.restHandles(), motion_.rig().restHandles());
  EXPECT_LE(sequence.lowestRatePerMinute(), 20);
  EXPECT_GE(sequence.highestRatePerMinute(), 220);
  EXPECT_EQ(sequence.standardRatePerMinute(), 75);
  EXPECT_EQ(sequence.phases(75).size(), CardiacCycle::phases(75).size());
  EXPECT_EQ(sequence.groups().size(), 7u);
  EXPECT_EQ(sequence.finestStepSeconds(), 0.01);
}

TEST_F(CavityHeartbeatTest, SaysWhichRatesLieBeyondTheData) {
  EXPECT_TRUE(heartbeat_.rateRemark(50).empty());
  EXPECT_TRUE(heartbeat_.rateRemark(171).empty());
  EXPECT_FALSE(heartbeat_.rateRemark(49).empty());
  EXPECT_FALSE(heartbeat_.rateRemark(200).empty());
}

TEST_F(CavityHeartbeatTest, AppliesTheCompensationToEveryPose) {
  const Eigen::Index n = heartbeat_.restHandles().rows();
  const Eigen::MatrixXd half =
      0.5 * Eigen::MatrixXd::Identity(n, n) + Eigen::MatrixXd::Constant(n, n, 0.5 / static_cast<double>(n));
  const sequences::PoseCompensation compensation(half, 1);
  const CavityFit fit = fitWith(compensation);
  const HeartInstant instant = heartInstant(cycle_, cycle_.at(0.4, 75));
  const HeartState corrected = fit.pose(instant, pose_);
  Points plain;
  motion_.pose(corrected, plain);
  compensation.apply(heartbeat_.restHandles(), plain);
  EXPECT_LT((pose_ - plain).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(CavityFit, RefusesACompensationForOtherHandles) {
  const HeartMotion motion(makeHeartRig(test::simpleHeart()));
  EXPECT_THROW(CavityFit(motion, sequences::PoseCompensation(Eigen::MatrixXd::Identity(3, 3)),
                         WallVolumes(motion.rig())),
               DataError);
}

TEST(CavityFit, SaysWhichVolumesCannotBeReached) {
  const HeartMotion motion(makeHeartRig(test::simpleHeart()));
  const auto unmoved = [](const Points&) { return CavityVolumes{120, 138}; };
  const auto broken = [](const Points&) { return CavityVolumes{std::nan(""), 138}; };
  EXPECT_THROW(CavityHeartbeat(CavityFit(motion, {}, unmoved), CardiacCycle()), DataError);
  EXPECT_THROW(CavityHeartbeat(CavityFit(motion, {}, broken), CardiacCycle()), DataError);
}

} // namespace
} // namespace viscera::heart
