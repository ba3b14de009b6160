#include <gtest/gtest.h>

#include "clouds.h"
#include "line_measures.h"
#include "shapes.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/deformation/deformer.h"
#include "viscera/deformation/least_stress.h"
#include "viscera/deformation/volume_lock.h"
#include "viscera/deformation/witness_gradients.h"
#include "viscera/geometry/volume.h"

/// What works on bindings works on Green coordinates too, whose points are not linear in the pose.
namespace viscera::coordinates {
namespace {

class GreenOrgan : public testing::Test {
protected:
  GreenOrgan() {
    handles_.positions = tests::onSphere(16, 60);
    organ_ = std::make_shared<geometry::TriangleMesh>(tests::sphere(3, 30));
    system_ = tests::builtIn("green");
    binding_ = deformation::bindOrgan(*system_, handles_, organ_->points, {}, progress_);
    pose_ = handles_.positions;
    pose_.row(3) += Eigen::RowVector3d(20, -12, 9);
    pose_.row(9) += Eigen::RowVector3d(-8, 10, 14);
  }

  HandleSet handles_;
  std::shared_ptr<geometry::TriangleMesh> organ_;
  std::shared_ptr<const CoordinateSystem> system_;
  std::shared_ptr<const Binding> binding_;
  Points pose_;
  Progress progress_;
};

TEST_F(GreenOrgan, TheVolumesGradientIsItsDerivative) {
  deformation::Deformer deformer(organ_, binding_, handles_.positions);
  deformer.setPose(pose_);
  const Points gradient = deformer.volumeGradient();
  const double step = 1e-3;
  for (const int handle : {0, 3, 9}) {
    for (int axis = 0; axis < 3; ++axis) {
      Points moved = pose_;
      moved(handle, axis) += step;
      deformer.setPose(moved);
      const double forward = deformer.volumeMm3();
      moved(handle, axis) -= 2 * step;
      deformer.setPose(moved);
      EXPECT_NEAR(gradient(handle, axis), (forward - deformer.volumeMm3()) / (2 * step), 1e-3);
    }
  }
}

TEST_F(GreenOrgan, ALockRestoresTheVolumeByNewtonSteps) {
  const double target = geometry::volume(organ_->points, organ_->triangles);
  const deformation::VolumeLock lock({{"sphere", organ_, binding_, target}});
  const std::vector<int> free = {0, 1, 2, 4, 5, 6, 7, 8, 10, 11, 12, 13, 14, 15};
  const auto restored = lock.restore(pose_, free, deformation::LeastDisplacement(), 40);
  EXPECT_TRUE(restored.restored) << restored.reason;
  EXPECT_LE(restored.relativeError, deformation::VolumeLock::kRelativeTolerance);
  EXPECT_EQ(restored.pose.row(3), pose_.row(3));
  EXPECT_NEAR(lock.volumes(restored.pose)[0] / target, 1, 1e-10);
}

TEST_F(GreenOrgan, LeastStressRestoresTheVolumeToo) {
  const double target = geometry::volume(organ_->points, organ_->triangles);
  const deformation::VolumeLock lock({{"sphere", organ_, binding_, target}});
  const Points witnesses = tests::cloud(200, 4, 15);
  const auto gradients = deformation::bindWitnesses(*system_, handles_, witnesses, {}, progress_);
  const std::vector<int> free = {0, 1, 2, 4, 5, 6, 7, 8, 10, 11, 12, 13, 14, 15};
  const auto restored =
      lock.restore(pose_, free, deformation::LeastStress(gradients, witnesses.rows(), {}), 60);
  EXPECT_TRUE(restored.restored) << restored.reason;
}

TEST_F(GreenOrgan, DraggingAHandleGivesThePosedOrgan) {
  deformation::Deformer dragged(organ_, binding_, handles_.positions), posed(organ_, binding_, pose_);
  dragged.moveHandle(3, pose_.row(3).transpose());
  dragged.moveHandle(9, pose_.row(9).transpose());
  posed.setPose(pose_);
  EXPECT_LT((dragged.points() - posed.points()).rowwise().norm().maxCoeff(), 1e-10);
}

} // namespace
} // namespace viscera::coordinates
