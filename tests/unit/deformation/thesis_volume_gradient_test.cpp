#include <array>
#include <random>

#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/coordinates/systems.h"
#include "viscera/deformation/deformer.h"
#include "viscera/deformation/place_handles.h"

namespace viscera::deformation {
namespace {

/// Table 5.1 of the thesis: weights and barycentric coordinates of the four integration points.
struct IntegrationPoint {
  double weight;
  Vec3 coordinates;
};
const std::array<IntegrationPoint, 4> kQuadrature = {{{-0.5625, {1.0 / 3, 1.0 / 3, 1.0 / 3}},
                                                      {25.0 / 48, {0.6, 0.2, 0.2}},
                                                      {25.0 / 48, {0.2, 0.6, 0.2}},
                                                      {25.0 / 48, {0.2, 0.2, 0.6}}}};

/// One triangle of a bound surface as annex B writes it: its corners in the pose, and the coordinates of its
/// corners with respect to handle q.
struct Corners {
  std::array<Vec3, 3> points;
  Vec3 alpha;

  /// N_j = (p2 - p1) x (p3 - p1).
  Vec3 normal() const { return (points[1] - points[0]).cross(points[2] - points[0]); }

  /// The derivative of N_j along an axis of the handle (B.1.1): the product rule over both edges.
  Vec3 normalSlope(int axis) const {
    const Vec3 unit = Vec3::Unit(axis);
    return (alpha[1] - alpha[0]) * unit.cross(points[2] - points[0]) +
           (alpha[2] - alpha[0]) * (points[1] - points[0]).cross(unit);
  }

  /// sum_k phi_k p_k (5.4) and its derivative along an axis of the handle (B.1.2).
  Vec3 integrated() const {
    Vec3 sum = Vec3::Zero();
    for (const auto& [weight, eta] : kQuadrature)
      sum += weight * (eta[0] * points[0] + eta[1] * points[1] + eta[2] * points[2]);
    return sum;
  }
  Vec3 integratedSlope(int axis) const {
    double sum = 0;
    for (const auto& [weight, eta] : kQuadrature)
      sum += weight * eta.dot(alpha);
    return sum * Vec3::Unit(axis);
  }
};

class ThesisVolumeGradient : public testing::Test {
protected:
  void SetUp() override {
    auto mesh = tests::sphere(4);
    mesh.points = mesh.points * Vec3(60, 45, 35).asDiagonal();
    const auto rest = std::make_shared<geometry::TriangleMesh>(std::move(mesh));
    coordinates::HandleSet handles;
    handles.positions = placeHandles(*rest, {24, true, 0.05, 0.15});
    Progress progress;
    const std::shared_ptr<const coordinates::Binding> binding =
        coordinates::builtInSystems().front()->bind(handles, rest->points, {}, progress);
    deformer_ = std::make_unique<Deformer>(rest, binding, handles.positions);
    std::mt19937 random(3);
    std::normal_distribution<double> normal(0, 12);
    Points pose = handles.positions;
    for (Eigen::Index i = 0; i < pose.size(); ++i)
      pose.data()[i] += normal(random);
    deformer_->setPose(pose);
  }

  Corners corners(Eigen::Index triangle, const Values& influence) const {
    Corners found;
    for (int corner = 0; corner < 3; ++corner) {
      const int vertex = deformer_->rest().triangles(triangle, corner);
      found.points[static_cast<std::size_t>(corner)] = deformer_->points().row(vertex).transpose();
      found.alpha[corner] = influence[vertex];
    }
    return found;
  }

  std::unique_ptr<Deformer> deformer_;
};

TEST_F(ThesisVolumeGradient, VolumeByTheFourPointQuadratureIsTheClosedForm) {
  const Values none = Values::Zero(deformer_->points().rows());
  double volume = 0;
  for (Eigen::Index j = 0; j < deformer_->rest().triangles.rows(); ++j) {
    const Corners triangle = corners(j, none);
    volume += triangle.normal().dot(triangle.integrated()) / 6;
  }
  EXPECT_NEAR(volume / deformer_->volumeMm3(), 1, 1e-12);
}

TEST_F(ThesisVolumeGradient, ExpressionOfAnnexBIsOurGradientForEveryHandle) {
  const Points& ours = deformer_->volumeGradient();
  for (int handle = 0; handle < ours.rows(); ++handle) {
    const Values influence = deformer_->binding().influence(handle);
    Vec3 theirs = Vec3::Zero();
    for (Eigen::Index j = 0; j < deformer_->rest().triangles.rows(); ++j) {
      const Corners triangle = corners(j, influence);
      for (int axis = 0; axis < 3; ++axis)
        theirs[axis] += (triangle.normalSlope(axis).dot(triangle.integrated()) +
                         triangle.normal().dot(triangle.integratedSlope(axis))) /
                        6;
    }
    EXPECT_LT((theirs.transpose() - ours.row(handle)).norm(), 1e-12 * ours.row(handle).norm())
        << "handle " << handle;
  }
}

/// Equation 5.7: what the handle itself contributes cancels, so its own position plays no part.
TEST_F(ThesisVolumeGradient, DoesNotChangeWhileItsHandleIsDragged) {
  const Points before = deformer_->volumeGradient();
  deformer_->moveHandle(11, Vec3(deformer_->pose().row(11)) + Vec3(40, -25, 60));
  const Points& after = deformer_->volumeGradient();
  EXPECT_LT((after.row(11) - before.row(11)).norm(), 1e-11 * before.row(11).norm());
  EXPECT_GT((after.row(12) - before.row(12)).norm(), 1e-6 * before.row(12).norm());
}

} // namespace
} // namespace viscera::deformation
