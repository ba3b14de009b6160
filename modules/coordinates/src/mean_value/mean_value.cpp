#include "viscera/coordinates/mean_value/mean_value.h"

#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "cage/cage.h"

namespace viscera::coordinates {
namespace {

/// Of the handles' size: a point this near to a handle is at it.
constexpr double kSamePlace = 1e-12;
/// A point whose unit vectors to a triangle's corners span less than this lies in the triangle's plane.
constexpr double kInPlane = 1e-10;
/// Below this so much cancels that the triangle is computed with more digits.
constexpr double kNearPlane = 1e-4;
/// How far outside a triangle, in barycentric coordinates, a point in its plane still lies in it.
constexpr double kOnTriangle = 1e-9;

template <class Real>
using Vector = Eigen::Matrix<Real, 3, 1>;

/// Corners of a triangle relative to the point.
template <class Real>
using Corners = std::array<Vector<Real>, 3>;

/// What a triangle adds to the weights of its corners, and the derivatives of that with respect to the point.
struct Share {
  std::array<double, 3> weights;
  std::array<Vec3, 3> gradients;
};

/// The plane through the point and an edge: the angle under which the edge is seen, the unit normal, and what
/// their derivatives need.
template <class Real>
struct EdgePlane {
  Vector<Real> normal;
  Vector<Real> edge;
  Vector<Real> angleSlope;
  Real length; ///< Of the cross product.
  Real angle;

  EdgePlane(const Vector<Real>& a, const Vector<Real>& b) {
    using std::atan2;
    const Vector<Real> cross = a.cross(b);
    length = cross.norm();
    normal = cross / length;
    angle = atan2(length, a.dot(b));
    edge = b - a;
    angleSlope = normal.cross(a / a.squaredNorm() - b / b.squaredNorm());
  }

  /// The derivative, with respect to the point, of `angle * normal . other` for a fixed `other`.
  Vector<Real> slopeAlong(const Vector<Real>& other) const {
    const Real along = normal.dot(other);
    const Vector<Real> across = (other - along * normal) / length;
    return along * angleSlope + angle * across.cross(edge);
  }
};

template <class Real>
Share shareOf(const Corners<Real>& corners, bool wantGradients) {
  const std::array<EdgePlane<Real>, 3> planes = {EdgePlane<Real>(corners[0], corners[1]),
                                                 EdgePlane<Real>(corners[1], corners[2]),
                                                 EdgePlane<Real>(corners[2], corners[0])};
  Vector<Real> mean = Vector<Real>::Zero();
  for (const auto& plane : planes)
    mean += plane.angle * plane.normal;
  const Real volume = corners[0].dot(corners[1].cross(corners[2]));
  const Vector<Real> area = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  Share share;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector<Real>&next = corners[(i + 1) % 3], &last = corners[(i + 2) % 3];
    const Vector<Real> opposite = next.cross(last);
    const Real weight = mean.dot(opposite) / (2 * volume);
    share.weights[i] = static_cast<double>(weight);
    if (!wantGradients)
      continue;
    Vector<Real> slope = mean.cross(last - next);
    for (const auto& plane : planes)
      slope += plane.slopeAlong(opposite);
    // The determinant's own derivative is the area vector, inward.
    share.gradients[i] = ((slope / 2 + weight * area) / volume).template cast<double>();
  }
  return share;
}

/// Barycentric coordinates of the origin in the triangle, when it lies in it.
bool liesIn(const Corners<double>& corners, Vec3& shares) {
  const Vec3 area = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    shares[static_cast<Eigen::Index>(i)] =
        corners[(i + 1) % 3].cross(corners[(i + 2) % 3]).dot(area) / area.squaredNorm();
    if (shares[static_cast<Eigen::Index>(i)] < -kOnTriangle)
      return false;
  }
  return true;
}

class MeanValueSolver final : public PointSolver {
public:
  MeanValueSolver(Points handles, Triangles cage)
      : handles_(std::move(handles)), cage_(std::move(cage)), size_(boundsOf(handles_).diagonal()) {}

  bool solve(const Vec3& point, Values& weights) const override {
    return add(point, weights, nullptr) != Place::nowhere;
  }

  bool solveGradients(const Vec3& point, Values& weights, Points& gradients) const override {
    return add(point, weights, &gradients) == Place::inSpace;
  }

private:
  enum class Place { inSpace, onCage, nowhere };

  Place add(const Vec3& point, Values& weights, Points* gradients) const {
    for (Eigen::Index i = 0; i < handles_.rows(); ++i)
      if ((handles_.row(i).transpose() - point).norm() <= kSamePlace * size_) {
        weights[i] = 1;
        return Place::onCage;
      }
    for (Eigen::Index t = 0; t < cage_.rows(); ++t)
      if (addTriangle(t, point, weights, gradients))
        return Place::onCage;
    const double sum = weights.sum();
    if (!(std::abs(sum) > 0))
      return Place::nowhere;
    weights /= sum;
    if (gradients) {
      const Eigen::RowVector3d ofSum = gradients->colwise().sum();
      *gradients = (*gradients - weights * ofSum) / sum;
    }
    return Place::inSpace;
  }

  /// True when the point lies in this triangle; the weights are then its barycentric coordinates.
  bool addTriangle(Eigen::Index triangle, const Vec3& point, Values& weights, Points* gradients) const {
    const auto items = cage_.row(triangle);
    Corners<double> corners;
    double distances = 1;
    for (int i = 0; i < 3; ++i) {
      corners[static_cast<std::size_t>(i)] = handles_.row(items[i]).transpose() - point;
      distances *= corners[static_cast<std::size_t>(i)].norm();
    }
    const double spanned = std::abs(corners[0].dot(corners[1].cross(corners[2]))) / distances;
    if (spanned < kInPlane) {
      Vec3 shares;
      if (!liesIn(corners, shares))
        return false; // Seen from the side it has no weight.
      weights.setZero();
      for (int i = 0; i < 3; ++i)
        weights[items[i]] += shares[i];
      return true;
    }
    const bool wantGradients = gradients != nullptr;
    const Share share =
        spanned < kNearPlane
            ? shareOf<long double>({corners[0].cast<long double>(), corners[1].cast<long double>(),
                                    corners[2].cast<long double>()},
                                   wantGradients)
            : shareOf<double>(corners, wantGradients);
    for (int i = 0; i < 3; ++i) {
      weights[items[i]] += share.weights[static_cast<std::size_t>(i)];
      if (wantGradients)
        gradients->row(items[i]) += share.gradients[static_cast<std::size_t>(i)].transpose();
    }
    return false;
  }

  Points handles_;
  Triangles cage_;
  double size_;
};

} // namespace

std::string MeanValue::summary() const {
  return "The classical coordinates of a closed cage; positive where the cage is convex";
}

Traits MeanValue::traits() const {
  Traits traits;
  traits.needsCage = true;
  traits.interpolates = true;
  traits.closedFormGradient = true;
  return traits;
}

std::unique_ptr<const PointSolver> MeanValue::prepare(const HandleSet& handles,
                                                      const ParameterValues&) const {
  return std::make_unique<MeanValueSolver>(handles.positions, cageOf(handles));
}

} // namespace viscera::coordinates
