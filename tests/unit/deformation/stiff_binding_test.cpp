#include "viscera/deformation/stiff_binding.h"

#include <cmath>
#include <memory>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/coordinates/systems.h"
#include "viscera/core/progress.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/deformation/deformer.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/geometry/volume.h"

namespace viscera::deformation {
namespace {

constexpr int kHandlesAround = 20;

/// A long body without symmetry, bound to handles around it.
struct Bone {
  explicit Bone(const std::string& system = "s-celestial") {
    geometry::TriangleMesh body = tests::sphere(2, 10);
    for (Eigen::Index i = 0; i < body.points.rows(); ++i) {
      body.points(i, 2) *= 3;
      body.points(i, 0) += 0.02 * body.points(i, 2) * body.points(i, 2) / 3;
    }
    mesh = std::make_shared<const geometry::TriangleMesh>(body);
    coordinates::HandleSet set;
    handles = placeHandles(*mesh, {kHandlesAround, true, 0.05, 0.15});
    set.positions = handles;
    Progress progress;
    for (const auto& made : coordinates::builtInSystems())
      if (made->id() == system)
        soft = bindOrgan(*made, set, mesh->points, {}, progress);
    rigid = rigidBinding(soft, *mesh);
  }

  Points randomPose(double mm) const {
    std::mt19937 random(7);
    std::normal_distribution<double> number(0, mm);
    return handles + Points::NullaryExpr(handles.rows(), 3, [&] { return number(random); });
  }

  std::shared_ptr<const geometry::TriangleMesh> mesh;
  Points handles;
  std::shared_ptr<const coordinates::Binding> soft, rigid;
};

Points posed(const coordinates::Binding& binding, const Points& pose) {
  Points points;
  binding.deform(pose, points);
  return points;
}

double misfit(const Bone& bone, const Points& points, const Points& wanted) {
  double sum = 0;
  for (Eigen::Index t = 0; t < bone.mesh->triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Eigen::Index v = bone.mesh->triangles(t, k);
      sum += geometry::areaOf(bone.mesh->points, bone.mesh->triangles, t) / 3 *
             (points.row(v) - wanted.row(v)).squaredNorm();
    }
  return sum;
}

TEST(RigidBinding, KeepsEveryDistanceInAnyPose) {
  const Bone bone;
  const Points rest = bone.mesh->points, now = posed(*bone.rigid, bone.randomPose(8));
  EXPECT_GT((now - rest).norm(), 1);
  EXPECT_GT((posed(*bone.soft, bone.randomPose(8)) - now).norm(), 1) << "soft tissue bends";
  for (Eigen::Index i = 0; i < rest.rows(); i += 7)
    for (Eigen::Index j = 0; j < i; j += 5)
      EXPECT_NEAR((now.row(i) - now.row(j)).norm(), (rest.row(i) - rest.row(j)).norm(), 1e-9);
  EXPECT_NEAR(geometry::volume(now, bone.mesh->triangles), geometry::volume(rest, bone.mesh->triangles),
              1e-9 * geometry::volume(rest, bone.mesh->triangles));
}

TEST(RigidBinding, StaysAtRestAndFollowsAMotionOfAllHandlesExactly) {
  const Bone bone;
  EXPECT_LE((posed(*bone.rigid, bone.handles) - bone.mesh->points).cwiseAbs().maxCoeff(), 1e-9);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(2.1, Vec3(1, -2, 3).normalized()).toRotationMatrix();
  const auto motion = [&](const Points& points) -> Points {
    return (points * turn.transpose()).rowwise() + Vec3(5, -60, 7).transpose();
  };
  EXPECT_LE((posed(*bone.rigid, motion(bone.handles)) - motion(bone.mesh->points)).cwiseAbs().maxCoeff(),
            1e-8);
}

TEST(RigidBinding, LiesNearerToWhereTheTissueWantsItThanAnyOtherPlaceNearby) {
  const Bone bone;
  const Points pose = bone.randomPose(6), wanted = posed(*bone.soft, pose), now = posed(*bone.rigid, pose);
  const double best = misfit(bone, now, wanted);
  std::mt19937 random(5);
  std::normal_distribution<double> number;
  const Vec3 middle = now.colwise().mean().transpose();
  for (int i = 0; i < 30; ++i) {
    const Vec3 axis = Vec3(number(random), number(random), number(random)).normalized();
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.02, axis).toRotationMatrix();
    const Vec3 by(0.1 * number(random), 0.1 * number(random), 0.1 * number(random));
    const Points other =
        ((now.rowwise() - middle.transpose()) * turn.transpose()).rowwise() + (middle + by).transpose();
    EXPECT_GT(misfit(bone, other, wanted), best);
  }
}

TEST(RigidBinding, PullsGradientsBackAsDifferencesDo) {
  for (const std::string system : {"s-celestial", "green"}) {
    const Bone bone(system);
    if (!bone.soft)
      continue;
    const Points pose = bone.randomPose(5);
    std::mt19937 random(9);
    std::normal_distribution<double> number;
    const Points weights = Points::NullaryExpr(bone.mesh->points.rows(), 3, [&] { return number(random); });
    Points gradient;
    bone.rigid->pullBack(pose, weights, gradient);
    const double step = 1e-4;
    for (int row = 0; row < pose.rows(); row += 3)
      for (int axis = 0; axis < 3; ++axis) {
        Points up = pose, down = pose;
        up(row, axis) += step;
        down(row, axis) -= step;
        const double difference =
            (posed(*bone.rigid, up) - posed(*bone.rigid, down)).cwiseProduct(weights).sum() / (2 * step);
        EXPECT_NEAR(gradient(row, axis), difference, 1e-5 * gradient.cwiseAbs().maxCoeff()) << system;
      }
  }
}

TEST(RigidBinding, ADragOfOneHandleEndsWhereThePoseDoes) {
  const Bone bone;
  Deformer deformer(bone.mesh, bone.rigid, bone.handles);
  const Vec3 there = bone.handles.row(3).transpose() + Vec3(9, 4, -20);
  deformer.moveHandle(3, there);
  Points pose = bone.handles;
  pose.row(3) = there.transpose();
  EXPECT_LE((deformer.points() - posed(*bone.rigid, pose)).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_NEAR(deformer.volumeMm3(), deformer.restVolumeMm3(), 1e-9 * deformer.restVolumeMm3());
  EXPECT_LE(deformer.volumeGradient().cwiseAbs().maxCoeff(), 1e-6) << "nothing changes its volume";
}

TEST(FixedBinding, StaysWhereItIs) {
  const Bone bone;
  const auto fixed = fixedBinding(bone.handles.rows(), bone.mesh->points);
  EXPECT_EQ(posed(*fixed, bone.randomPose(9)), bone.mesh->points);
  Points gradient;
  fixed->pullBack(bone.randomPose(9), Points::Ones(bone.mesh->points.rows(), 3), gradient);
  EXPECT_EQ(gradient, Points::Zero(bone.handles.rows(), 3));
}

} // namespace
} // namespace viscera::deformation
