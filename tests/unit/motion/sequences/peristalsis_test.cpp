#include "viscera/sequences/peristalsis.h"

#include <cmath>

#include <gtest/gtest.h>

#include "simple_stomach.h"
#include "viscera/core/error.h"

namespace viscera::sequences {
namespace {

/// A stand-in for a measured mesh: rings of discs. Quadratic in the widening.
class RingVolume {
public:
  explicit RingVolume(const StomachRig& rig) : rig_(rig) {}

  std::array<double, 4> operator()(const Points& pose, const Points& direction) const {
    std::array<double, 4> sum{};
    for (Eigen::Index i = 0; i < pose.rows(); ++i) {
      const StomachHandle& handle = rig_.handles[static_cast<std::size_t>(i)];
      if (handle.region == StomachRegion::farCorner)
        continue;
      const Vec3 from = pose.row(i).transpose() - handle.center;
      const Vec3 change = direction.row(i);
      sum[0] += from.squaredNorm() / 1000;
      sum[1] += 2 * from.dot(change) / 1000;
      sum[2] += change.squaredNorm() / 1000;
    }
    return sum;
  }

  double at(const Points& pose) const { return (*this)(pose, Points::Zero(pose.rows(), 3))[0]; }

private:
  const StomachRig& rig_;
};

class PeristalsisTest : public ::testing::Test {
protected:
  StomachRig rig_ = makeStomachRig(test::simpleStomach());
  RingVolume volume_{rig_};
  Peristalsis peristalsis_{rig_, {}, volume_};
  Points pose_;
};

TEST_F(PeristalsisTest, keepsTheVolumeToRoundingAtEveryRate) {
  const double kept = volume_.at(rig_.restHandles());
  EXPECT_NEAR(peristalsis_.keptMl(), kept, 1e-12 * kept);
  for (const double rate : {1.0, 3.0, 4.4, 6.0})
    for (double t = 0; t < 60; t += 1.3) {
      peristalsis_.poseAt(t, rate, pose_);
      EXPECT_NEAR(volume_.at(pose_), kept, 1e-11 * kept) << rate << " " << t;
    }
}

TEST_F(PeristalsisTest, upperStomachTakesInWhatIsPressedOut) {
  for (double t = 0; t < 20; t += 1)
    EXPECT_GT(peristalsis_.widening(t, 3), 0.01);
}

TEST_F(PeristalsisTest, narrowsItsRingsWhereTheWavesAre) {
  const double t = 14;
  peristalsis_.poseAt(t, 3, pose_);
  for (Eigen::Index i = 0; i < pose_.rows(); ++i) {
    const StomachHandle& handle = rig_.handles[static_cast<std::size_t>(i)];
    if (handle.region != StomachRegion::antrum)
      continue;
    const double ratio =
        (pose_.row(i).transpose() - handle.center).norm() / (handle.position - handle.center).norm();
    EXPECT_NEAR(ratio, 1 - peristalsis_.waves().constriction(handle.s, t, 3), 0.02);
  }
}

TEST_F(PeristalsisTest, fixedHandlesStay) {
  const Points rest = rig_.restHandles();
  peristalsis_.poseAt(7, 3, pose_);
  for (Eigen::Index i = 0; i < pose_.rows(); ++i) {
    const StomachRegion region = rig_.handles[static_cast<std::size_t>(i)].region;
    if (region == StomachRegion::fixed || region == StomachRegion::farCorner) {
      EXPECT_EQ(pose_.row(i), rest.row(i));
    }
  }
}

TEST_F(PeristalsisTest, repeatsAndMovesWithoutJumps) {
  Points later;
  peristalsis_.poseAt(4, 3, pose_);
  peristalsis_.poseAt(64, 3, later);
  EXPECT_LT((pose_ - later).cwiseAbs().maxCoeff(), 1e-9);
  peristalsis_.poseAt(0, 3, pose_);
  for (double t = 0.05; t < 20.05; t += 0.05) {
    peristalsis_.poseAt(t, 3, later);
    EXPECT_LT((pose_ - later).rowwise().norm().maxCoeff(), 0.6) << t;
    pose_ = later;
  }
}

TEST_F(PeristalsisTest, describesItselfAsASequence) {
  EXPECT_EQ(peristalsis_.id(), "peristalsis");
  EXPECT_EQ(peristalsis_.standardRatePerMinute(), 3);
  EXPECT_EQ(peristalsis_.restHandles(), rig_.restHandles());
  EXPECT_EQ(peristalsis_.groups().size(), 5u);
  EXPECT_FALSE(peristalsis_.phases(3).empty());
}

TEST_F(PeristalsisTest, refusesWhatCannotBeKept) {
  const auto stiff = [&](const Points& pose, const Points&) {
    return std::array<double, 4>{volume_.at(pose), 0, 0, 0};
  };
  EXPECT_THROW(Peristalsis(rig_, {}, stiff), DataError);
  EXPECT_THROW(Peristalsis(rig_, PoseCompensation(Eigen::MatrixXd::Identity(3, 3)), volume_), DataError);
}

} // namespace
} // namespace viscera::sequences
