#include "viscera/deformation/stiff_binding.h"

#include <utility>

#include <Eigen/LU>
#include <Eigen/SVD>

#include "viscera/geometry/volume.h"

namespace viscera::deformation {
namespace {

using coordinates::Binding;
using coordinates::BindingReport;
using Matrix3 = Eigen::Matrix3d;

/// The share of every vertex in the area of a surface; equal shares where it has none.
Values areaShares(const geometry::TriangleMesh& rest) {
  Values shares = Values::Zero(rest.points.rows());
  for (Eigen::Index t = 0; t < rest.triangles.rows(); ++t) {
    const double third = geometry::areaOf(rest.points, rest.triangles, t) / 3;
    for (int k = 0; k < 3; ++k)
      shares[rest.triangles(t, k)] += third;
  }
  const double area = shares.sum();
  if (!(area > 0))
    return Values::Constant(rest.points.rows(), 1.0 / static_cast<double>(rest.points.rows()));
  return shares / area;
}

Matrix3 crossMatrix(const Vec3& v) {
  Matrix3 matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

/// Where a rigid body lies: `x = rotation (p - middle at rest) + middle`.
struct BodyPlace {
  Matrix3 rotation = Matrix3::Identity();
  Vec3 middle = Vec3::Zero();
  Matrix3 stretch = Matrix3::Zero(); ///< P of the polar decomposition A = R P.
};

class RigidBinding final : public Binding {
public:
  RigidBinding(std::shared_ptr<const Binding> soft, const geometry::TriangleMesh& rest)
      : soft_(std::move(soft)), shares_(areaShares(rest)) {
    const Vec3 middle = rest.points.transpose() * shares_;
    arms_ = rest.points.rowwise() - middle.transpose();
  }

  Eigen::Index handleCount() const override { return soft_->handleCount(); }
  Eigen::Index pointCount() const override { return soft_->pointCount(); }
  const BindingReport& report() const override { return soft_->report(); }

  void deform(const Points& pose, Points& points, Threads threads) const override {
    soft_->deform(pose, points, threads);
    const BodyPlace placed = placement(points);
    points.noalias() = arms_ * placed.rotation.transpose();
    points.rowwise() += placed.middle.transpose();
  }

  void moveHandle(const Points& pose, int handle, const Vec3& delta, Points& points,
                  Threads threads) const override {
    Points moved = pose;
    moved.row(handle) += delta.transpose();
    deform(moved, points, threads);
  }

  void pullBack(const Points& pose, const Points& pointGradient, Points& handleGradient,
                Threads threads) const override {
    Points softPoints;
    soft_->deform(pose, softPoints, threads);
    const BodyPlace placed = placement(softPoints);
    // Let x = R u + m, u = p - c: dE = tau . omega + G . dm, where R^T dR = [omega] and
    // tau = sum u x R^T g, G = sum g. From A = sum w (q - m) u^T = R P follows
    // (tr(P) I - P) omega = axis(R^T dA - dA^T R), so with (tr(P) I - P) y = tau
    // dE/dq = w (R (y x u) + G).
    const Vec3 sum = pointGradient.colwise().sum().transpose();
    Vec3 torque = Vec3::Zero();
    for (Eigen::Index i = 0; i < arms_.rows(); ++i)
      torque +=
          arms_.row(i).transpose().cross(placed.rotation.transpose() * pointGradient.row(i).transpose());
    const Matrix3 stiffness = placed.stretch.trace() * Matrix3::Identity() - placed.stretch;
    const Eigen::FullPivLU<Matrix3> solver(stiffness);
    const Vec3 turn = solver.isInvertible() ? Vec3(solver.solve(torque)) : Vec3(Vec3::Zero());
    const Matrix3 turned = placed.rotation * crossMatrix(turn);
    Points ofSoft = arms_ * turned.transpose();
    ofSoft.rowwise() += sum.transpose();
    ofSoft.array().colwise() *= shares_.array();
    soft_->pullBack(pose, ofSoft, handleGradient, threads);
  }

  Values influence(int handle) const override { return soft_->influence(handle); }
  double weight(Eigen::Index point, int handle) const override { return soft_->weight(point, handle); }

private:
  /// The best fit to where the vertices would be in soft tissue.
  BodyPlace placement(const Points& softPoints) const {
    BodyPlace placed;
    placed.middle = softPoints.transpose() * shares_;
    const Points away = softPoints.rowwise() - placed.middle.transpose();
    const Matrix3 covariance = away.transpose() * (arms_.array().colwise() * shares_.array()).matrix();
    const Eigen::JacobiSVD<Matrix3> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Vec3 signs = Vec3::Ones();
    if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0)
      signs.z() = -1; // The least singular value: a reflection is no motion.
    placed.rotation = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
    placed.stretch =
        svd.matrixV() * (svd.singularValues().cwiseProduct(signs)).asDiagonal() * svd.matrixV().transpose();
    return placed;
  }

  std::shared_ptr<const Binding> soft_;
  Values shares_; ///< Of every vertex in the fit; their sum is 1.
  Points arms_;   ///< From the middle to every vertex, at rest.
};

class FixedBinding final : public Binding {
public:
  FixedBinding(Eigen::Index handles, Points rest) : handles_(handles), rest_(std::move(rest)) {}

  Eigen::Index handleCount() const override { return handles_; }
  Eigen::Index pointCount() const override { return rest_.rows(); }
  const BindingReport& report() const override { return report_; }
  void deform(const Points&, Points& points, Threads) const override { points = rest_; }
  void moveHandle(const Points&, int, const Vec3&, Points& points, Threads) const override { points = rest_; }
  void pullBack(const Points&, const Points&, Points& handleGradient, Threads) const override {
    handleGradient = Points::Zero(handles_, 3);
  }
  Values influence(int) const override { return Values::Zero(rest_.rows()); }
  double weight(Eigen::Index, int) const override { return 0; }

private:
  Eigen::Index handles_;
  Points rest_;
  BindingReport report_;
};

} // namespace

std::shared_ptr<const Binding> rigidBinding(std::shared_ptr<const Binding> soft,
                                            const geometry::TriangleMesh& rest) {
  return std::make_shared<RigidBinding>(std::move(soft), rest);
}

std::shared_ptr<const Binding> fixedBinding(Eigen::Index handles, Points rest) {
  return std::make_shared<FixedBinding>(handles, std::move(rest));
}

} // namespace viscera::deformation
