#include "viscera/deformation/least_stress.h"

#include <gtest/gtest.h>

#include "clouds.h"
#include "shapes.h"
#include "viscera/coordinates/systems.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/deformation/grid_witnesses.h"
#include "viscera/deformation/volume_lock.h"
#include "viscera/deformation/witness_gradients.h"

namespace viscera::deformation {
namespace {

/// A ball in 24 handles of which three have been pulled.
class LeastStressTest : public testing::Test {
protected:
  LeastStressTest() {
    handles_.positions = tests::onSphere(24, 45);
    const auto ball = std::make_shared<const geometry::TriangleMesh>(tests::sphere(4, 30));
    Progress progress;
    deformer_ = std::make_unique<Deformer>(ball, bindOrgan(*system_, handles_, ball->points, {}, progress),
                                           handles_.positions);
    const WitnessMesh mesh = gridWitnesses(*ball, 800, progress);
    witnesses_ = mesh.witnesses;
    gradients_ = bindWitnesses(*system_, handles_, mesh.points, {}, progress);
    pulled_ = handles_.positions;
    pulled_.row(3) += Eigen::RowVector3d(10, 4, 18);
    pulled_.row(4) += Eigen::RowVector3d(-12, 9, 6);
    pulled_.row(11) *= 1.4;
  }

  /// The pose with the rest volume that a model finds, and its mean squared stress, rad^2.
  Points restored(const RestorationModel& model) {
    deformer_->setPose(pulled_);
    restoreVolume(*deformer_, deformer_->restVolumeMm3(), restingHandles(handles_.positions, pulled_), model);
    EXPECT_NEAR(deformer_->volumeMm3(), deformer_->restVolumeMm3(), 1e-9 * deformer_->restVolumeMm3());
    return deformer_->pose();
  }
  StressMap mapAt(const Points& pose) const {
    StressMap map;
    gradients_->evaluate(pose, map);
    return map;
  }

  std::shared_ptr<const coordinates::CoordinateSystem> system_ = coordinates::sCelestial();
  coordinates::HandleSet handles_;
  std::unique_ptr<Deformer> deformer_;
  std::shared_ptr<const WitnessGradients> gradients_;
  Eigen::Index witnesses_ = 0;
  Points pulled_;
};

TEST_F(LeastStressTest, EndsWithLessStressThanLeastDisplacementAtTheSameVolume) {
  const LeastStress model(gradients_, witnesses_);
  const StressMap before = mapAt(pulled_);
  const StressMap displaced = mapAt(restored(LeastDisplacement())), relaxed = mapAt(restored(model));
  EXPECT_LT(relaxed.rotationalStress.mean(), 0.95 * displaced.rotationalStress.mean());
  EXPECT_LT(relaxed.rotationalStress.squaredNorm(), 0.9 * displaced.rotationalStress.squaredNorm());
  EXPECT_LT(relaxed.rotationalStress.squaredNorm(), before.rotationalStress.squaredNorm());
}

TEST_F(LeastStressTest, LeavesTheHandlesThatAreNotFree) {
  const Points pose = restored(LeastStress(gradients_, witnesses_));
  for (const int held : {3, 4, 11})
    EXPECT_EQ(pose.row(held), pulled_.row(held));
}

TEST_F(LeastStressTest, DirectionAddsTheLeastStressForItsChangeOfVolume) {
  // The restoring handles only, at rest, where there is no stress yet: any other motion of the same change of
  // volume costs more.
  const LeastStress model(gradients_, witnesses_);
  deformer_->setPose(handles_.positions);
  const Points gradient = deformer_->volumeGradient();
  std::vector<int> free;
  for (int i = 0; i < 20; ++i)
    free.push_back(i);
  const auto changeOf = [&](const Points& motion) { return gradient.cwiseProduct(motion).sum(); };
  const auto costOf = [&](const Points& motion) {
    const double part = 1e-4 * deformer_->restVolumeMm3() / changeOf(motion);
    return model.cost(handles_.positions + part * motion);
  };
  const Points best = model.direction(handles_.positions, gradient, free);
  EXPECT_EQ(best.bottomRows(4), Points::Zero(4, 3));
  const double least = costOf(best);
  EXPECT_LT(least, costOf(LeastDisplacement().direction(handles_.positions, gradient, free)));
  for (unsigned seed = 0; seed < 20; ++seed) {
    Points other = best + 0.3 * best.norm() * tests::cloud(24, seed) / std::sqrt(24.0);
    other.bottomRows(4).setZero();
    EXPECT_LT(least, costOf(other));
  }
}

TEST_F(LeastStressTest, CostIsZeroForARigidMotionAndAboutTheSquaredStressElsewhere) {
  const LeastStress model(gradients_, witnesses_);
  EXPECT_LT(model.cost(handles_.positions * tests::turn(0.8)), 1e-18);
  EXPECT_LT(model.cost(1.3 * handles_.positions), 1e-18);
  const Points slightly = handles_.positions + 0.05 * (pulled_ - handles_.positions);
  const double squared = mapAt(slightly).rotationalStress.squaredNorm() / double(witnesses_);
  EXPECT_GT(model.cost(slightly), squared);
  EXPECT_LT(model.cost(slightly), 4 * squared);
}

TEST_F(LeastStressTest, GivesTheSameBitsForAnyNumberOfThreads) {
  EXPECT_EQ(restored(LeastStress(gradients_, witnesses_, {1})),
            restored(LeastStress(gradients_, witnesses_, {3})));
}

} // namespace
} // namespace viscera::deformation
