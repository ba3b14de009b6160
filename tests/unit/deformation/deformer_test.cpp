#include "viscera/deformation/deformer.h"

#include <random>

#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/coordinates/systems.h"
#include "viscera/core/error.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/geometry/volume.h"

namespace viscera::deformation {
namespace {

/// A sphere of 30 mm with twenty handles.
class DeformerTest : public testing::Test {
protected:
  static Deformer sphereDeformer(Threads threads = {}) {
    auto organ = std::make_shared<geometry::TriangleMesh>(tests::sphere(4, 30, {5, -80, 200}));
    Placement placement;
    placement.count = 20;
    coordinates::HandleSet handles;
    handles.positions = placeHandles(*organ, placement);
    Progress progress;
    auto binding = bindOrgan(*coordinates::sCelestial(), handles, organ->points, {{}, threads}, progress);
    return Deformer(organ, binding, handles.positions, threads);
  }

  static Points randomPose(const Deformer& deformer, unsigned seed, double amount = 5) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> by(-amount, amount);
    Points pose = deformer.restHandles();
    for (Eigen::Index i = 0; i < pose.size(); ++i)
      pose.data()[i] += by(random);
    return pose;
  }
};

} // namespace

TEST_F(DeformerTest, StartsAtRest) {
  Deformer deformer = sphereDeformer();
  EXPECT_EQ(deformer.points(), deformer.rest().points);
  EXPECT_EQ(deformer.maxDisplacementMm(), 0);
  EXPECT_EQ(deformer.volumeMm3(), deformer.restVolumeMm3());
}

TEST_F(DeformerTest, FollowsATranslationAndAScalingOfAllHandles) {
  Deformer deformer = sphereDeformer();
  const Vec3 shift(3, -4, 12);
  Points pose = deformer.restHandles().rowwise() + shift.transpose();
  deformer.setPose(pose);
  EXPECT_NEAR(deformer.maxDisplacementMm(), 13, 1e-9);
  EXPECT_NEAR(deformer.volumeMm3(), deformer.restVolumeMm3(), 1e-9 * deformer.restVolumeMm3());
  deformer.setPose(2 * deformer.restHandles());
  EXPECT_NEAR(deformer.volumeMm3(), 8 * deformer.restVolumeMm3(), 1e-9 * deformer.restVolumeMm3());
}

TEST_F(DeformerTest, MovesOneHandleAsAWholePoseDoes) {
  Deformer dragged = sphereDeformer(), posed = sphereDeformer();
  Points pose = randomPose(dragged, 1);
  dragged.setPose(pose);
  const Vec3 to = pose.row(11).transpose() + Vec3(4, 5, -6);
  dragged.moveHandle(11, to);
  pose.row(11) = to.transpose();
  posed.setPose(pose);
  EXPECT_EQ(dragged.pose(), pose);
  EXPECT_LT((dragged.points() - posed.points()).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_NEAR(dragged.volumeMm3(), posed.volumeMm3(), 1e-9 * posed.restVolumeMm3());
}

TEST_F(DeformerTest, GradientIsTheChangeOfVolume) {
  Deformer deformer = sphereDeformer();
  const Points pose = randomPose(deformer, 2);
  deformer.setPose(pose);
  const Points gradient = deformer.volumeGradient();
  ASSERT_EQ(gradient.rows(), pose.rows());
  const double step = 1e-3;
  for (int handle = 0; handle < static_cast<int>(pose.rows()); ++handle)
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 at = pose.row(handle).transpose();
      deformer.moveHandle(handle, at + step * Vec3::Unit(axis));
      const double above = deformer.volumeMm3();
      deformer.moveHandle(handle, at - step * Vec3::Unit(axis));
      const double below = deformer.volumeMm3();
      deformer.moveHandle(handle, at);
      EXPECT_NEAR((above - below) / (2 * step), gradient(handle, axis),
                  1e-6 * gradient.cwiseAbs().maxCoeff());
    }
}

TEST_F(DeformerTest, VolumeIsAffineInOneHandle) {
  Deformer deformer = sphereDeformer();
  const Vec3 at = deformer.restHandles().row(9).transpose(), way(6, 2, -3);
  double volumes[3];
  for (int i = 0; i < 3; ++i) {
    deformer.moveHandle(9, at + i * way);
    volumes[i] = deformer.volumeMm3();
  }
  EXPECT_GT(std::abs(volumes[1] - volumes[0]), 1e-4 * deformer.restVolumeMm3());
  EXPECT_NEAR(volumes[2] - volumes[1], volumes[1] - volumes[0], 1e-10 * deformer.restVolumeMm3());
}

TEST_F(DeformerTest, ResetGivesTheRestPointsExactly) {
  Deformer deformer = sphereDeformer();
  deformer.setPose(randomPose(deformer, 3));
  ASSERT_GT(deformer.maxDisplacementMm(), 1);
  deformer.reset();
  EXPECT_EQ(deformer.points(), deformer.rest().points);
  EXPECT_EQ(deformer.pose(), deformer.restHandles());
  EXPECT_EQ(deformer.volumeMm3(), deformer.restVolumeMm3());
}

TEST_F(DeformerTest, KeepsItsArraysInPlace) {
  Deformer deformer = sphereDeformer();
  const double* points = deformer.points().data();
  const float* normals = deformer.normals().data();
  deformer.setPose(randomPose(deformer, 4));
  deformer.moveHandle(3, Vec3(1, 2, 3));
  deformer.reset();
  EXPECT_EQ(deformer.points().data(), points);
  EXPECT_EQ(deformer.normals().data(), normals);
}

TEST_F(DeformerTest, NormalsBelongToThePresentPose) {
  Deformer deformer = sphereDeformer();
  const geometry::Normals rest = deformer.normals();
  Points mirrored = deformer.restHandles();
  mirrored.col(0) *= -1;
  deformer.setPose(mirrored); // Turns the surface inside out: normals flip but for the mirrored axis.
  geometry::Normals expected = -rest;
  expected.col(0) = rest.col(0);
  EXPECT_LT((deformer.normals() - expected).cwiseAbs().maxCoeff(), 1e-4);
  EXPECT_NEAR(deformer.volumeMm3(), -deformer.restVolumeMm3(), 1e-9 * deformer.restVolumeMm3());
}

TEST_F(DeformerTest, RefusesPosesThatAreOfAnotherSizeOrNotFinite) {
  Deformer deformer = sphereDeformer();
  EXPECT_THROW(deformer.setPose(Points::Zero(3, 3)), DataError);
  Points pose = deformer.restHandles();
  pose(4, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(deformer.setPose(pose), DataError);
  EXPECT_THROW(deformer.moveHandle(4, pose.row(4).transpose()), DataError);
  EXPECT_EQ(deformer.points(), deformer.rest().points) << "a refused pose left traces";
}

TEST_F(DeformerTest, GivesTheSameBitsForAnyNumberOfThreads) {
  Deformer one = sphereDeformer({1});
  const Points pose = randomPose(one, 5);
  one.setPose(pose);
  one.moveHandle(2, Vec3(1, 2, 3));
  for (const int threads : {2, 3}) {
    Deformer more = sphereDeformer({threads});
    more.setPose(pose);
    more.moveHandle(2, Vec3(1, 2, 3));
    EXPECT_EQ(more.points(), one.points());
    EXPECT_EQ(more.normals(), one.normals());
    EXPECT_EQ(more.volumeMm3(), one.volumeMm3());
    EXPECT_EQ(more.volumeGradient(), one.volumeGradient());
  }
}

} // namespace viscera::deformation
