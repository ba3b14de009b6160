#include "viscera/sequences/heartbeat.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "simple_heart.h"
#include "viscera/core/error.h"

namespace viscera::sequences {
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

class CalibratedHeartbeatTest : public ::testing::Test {
protected:
  HeartMotion motion_{makeHeartRig(test::simpleHeart())};
  CardiacCycle cycle_;
  WallVolumes volumes_{motion_.rig()};
  Progress progress_;
  HeartbeatCalibration calibration_ = calibrateHeartbeat(motion_, cycle_, {}, std::cref(volumes_), progress_);
  CalibratedHeartbeat heartbeat_{motion_, cycle_, {}, calibration_};
  Points pose_;
};

TEST_F(CalibratedHeartbeatTest, cavitiesHoldWhatTheCurvesSayAtAnyTimeAndRate) {
  double left = 0;
  double right = 0;
  for (const double rate : {20.0, 50.0, 75.0, 150.0, 220.0}) {
    for (int k = 0; k < 331; ++k) {
      const double seconds = k / 331.0 * 60 / rate;
      heartbeat_.poseAt(seconds, rate, pose_);
      const CavityVolumes measured = volumes_(pose_);
      const CavityVolumes wanted = cycle_.volumes(cycle_.referencePhase(seconds, rate));
      left = std::max(left, std::abs(measured.leftMl - wanted.leftMl));
      right = std::max(right, std::abs(measured.rightMl - wanted.rightMl));
    }
  }
  EXPECT_LT(left, 0.25);
  EXPECT_LT(right, 0.5);
}

TEST_F(CalibratedHeartbeatTest, calibrationNeedsFewMeasurements) {
  volumes_.calls = 0;
  calibrateHeartbeat(motion_, cycle_, {}, std::cref(volumes_), progress_, 96);
  EXPECT_LT(volumes_.calls, 96 * 8);
}

TEST_F(CalibratedHeartbeatTest, repeatsWithTheBeat) {
  Points later;
  for (const double seconds : {0.0, 0.21, 0.55}) {
    heartbeat_.poseAt(seconds, 75, pose_);
    heartbeat_.poseAt(seconds + 3 * 0.8, 75, later);
    EXPECT_LT((pose_ - later).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST_F(CalibratedHeartbeatTest, movesWithoutJumps) {
  Points next;
  heartbeat_.poseAt(0, 75, pose_);
  for (int k = 1; k <= 800; ++k) {
    heartbeat_.poseAt(k * 1e-3, 75, next);
    EXPECT_LT((next - pose_).rowwise().norm().maxCoeff(), 0.5) << k;
    pose_ = next;
  }
}

TEST_F(CalibratedHeartbeatTest, passesThroughTheSameStatesAtEveryRate) {
  Points other;
  heartbeat_.poseAtPhase(0.31, pose_);
  for (const double rate : {40.0, 190.0}) {
    double low = 0;
    double high = 60 / rate;
    while (high - low > 1e-13) {
      const double middle = 0.5 * (low + high);
      (cycle_.referencePhase(middle, rate) < 0.31 ? low : high) = middle;
    }
    heartbeat_.poseAt(low, rate, other);
    EXPECT_LT((pose_ - other).cwiseAbs().maxCoeff(), 1e-6);
  }
}

TEST_F(CalibratedHeartbeatTest, describesItselfAsASequence) {
  const Sequence& sequence = heartbeat_;
  EXPECT_EQ(sequence.id(), "heartbeat");
  EXPECT_EQ(sequence.restHandles(), motion_.rig().restHandles());
  EXPECT_LE(sequence.lowestRatePerMinute(), 20);
  EXPECT_GE(sequence.highestRatePerMinute(), 220);
  EXPECT_EQ(sequence.standardRatePerMinute(), 75);
  EXPECT_EQ(sequence.phases(75).size(), 5u);
  EXPECT_EQ(sequence.groups().size(), 7u);
}

TEST_F(CalibratedHeartbeatTest, appliesTheCompensationToEveryPose) {
  const Eigen::Index n = heartbeat_.restHandles().rows();
  const Eigen::MatrixXd half =
      0.5 * Eigen::MatrixXd::Identity(n, n) + Eigen::MatrixXd::Constant(n, n, 0.5 / static_cast<double>(n));
  const PoseCompensation compensation(half, 1);
  const CalibratedHeartbeat compensated(motion_, cycle_, compensation, calibration_);
  Points plain;
  heartbeat_.poseAt(0.4, 75, plain);
  compensated.poseAt(0.4, 75, pose_);
  compensation.apply(heartbeat_.restHandles(), plain);
  EXPECT_LT((pose_ - plain).cwiseAbs().maxCoeff(), 1e-12);
}

TEST_F(CalibratedHeartbeatTest, refusesACalibrationThatDoesNotFit) {
  HeartbeatCalibration broken = calibration_;
  broken.rightShift.pop_back();
  EXPECT_THROW(CalibratedHeartbeat(motion_, cycle_, {}, broken), DataError);
  broken = calibration_;
  broken.leftGain[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(CalibratedHeartbeat(motion_, cycle_, {}, broken), DataError);
  EXPECT_THROW(
      CalibratedHeartbeat(motion_, cycle_, PoseCompensation(Eigen::MatrixXd::Identity(3, 3)), calibration_),
      DataError);
}

TEST(HeartbeatCalibration, saysWhereVolumesCannotBeReached) {
  const HeartMotion motion(makeHeartRig(test::simpleHeart()));
  Progress progress;
  const auto unmoved = [](const Points&) { return CavityVolumes{130.5, 138}; };
  const auto broken = [](const Points&) { return CavityVolumes{std::nan(""), 138}; };
  EXPECT_THROW(calibrateHeartbeat(motion, CardiacCycle(), {}, unmoved, progress), DataError);
  EXPECT_THROW(calibrateHeartbeat(motion, CardiacCycle(), {}, broken, progress), DataError);
}

TEST(HeartbeatCalibration, canBeCancelled) {
  const HeartMotion motion(makeHeartRig(test::simpleHeart()));
  Progress progress;
  progress.cancel();
  EXPECT_THROW(calibrateHeartbeat(motion, CardiacCycle(), {}, WallVolumes(motion.rig()), progress),
               Cancelled);
}

} // namespace
} // namespace viscera::sequences
