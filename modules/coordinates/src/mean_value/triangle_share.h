#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>

#include "viscera/core/arrays.h"

/// Computes the contribution of one triangle to mean value coordinates (thesis 3.1, annex B.3).
namespace viscera::coordinates {

/// A point whose unit vectors to a triangle's corners span less than this lies in the triangle's plane.
inline constexpr double kInPlane = 1e-10;
/// Below this, cancellation is so large that the triangle is computed with more digits.
inline constexpr double kNearPlane = 1e-4;

template <class Real>
using Vector = Eigen::Matrix<Real, 3, 1>;

/// Corners of a triangle relative to the point.
template <class Real>
using Corners = std::array<Vector<Real>, 3>;

/// The contribution of a triangle to the weights of its corners, and its derivatives with respect to the
/// point.
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

/// The same with more digits, for a point near the plane of the triangle.
inline Share preciseShareOf(const Corners<double>& corners, bool wantGradients) {
  return shareOf<long double>(
      {corners[0].cast<long double>(), corners[1].cast<long double>(), corners[2].cast<long double>()},
      wantGradients);
}

/// How a point lies to a triangle whose plane it is in, or nearly.
struct BesideTriangle {
  Vec3 shares;   ///< Barycentric coordinates of the foot in the plane.
  double height; ///< Of the point over the plane, mm.
  double beside; ///< How far the foot is beyond the edge it is farthest beyond, mm; 0 in the triangle.
};

/// Takes corners relative to the point. A triangle without an area has a height that is not a number.
inline BesideTriangle besideTriangle(const Corners<double>& corners) {
  const Vec3 area = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const double twice = area.norm();
  // All corners have the same height; rounding leaves most of it in the nearest one's.
  const auto nearer = [](const Vec3& a, const Vec3& b) { return a.squaredNorm() < b.squaredNorm(); };
  const Vec3& nearest = *std::min_element(corners.begin(), corners.end(), nearer);
  BesideTriangle found{Vec3::Zero(), std::abs(nearest.dot(area)) / twice, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    // b_i = (v_i+1 x v_i+2) . n / |n|^2, the signed area opposite to corner i over the whole one; b_i |n|
    // over the length of that edge is the distance from it.
    const Vec3 &next = corners[(i + 1) % 3], &last = corners[(i + 2) % 3];
    const double share = next.cross(last).dot(area) / (twice * twice);
    found.shares[static_cast<Eigen::Index>(i)] = share;
    found.beside = std::max(found.beside, -share * twice / (last - next).norm());
  }
  return found;
}

/// The share of a triangle whose corners are relative to the point; nothing for a point in its plane: a
/// triangle seen edge-on has no weight, and the caller handles points in the triangle itself.
inline std::optional<Share> shareOfTriangle(const Corners<double>& corners, bool wantGradients) {
  const double distances = corners[0].norm() * corners[1].norm() * corners[2].norm();
  const double spanned = std::abs(corners[0].dot(corners[1].cross(corners[2]))) / distances;
  if (!(spanned >= kInPlane))
    return std::nullopt;
  if (spanned >= kNearPlane)
    return shareOf<double>(corners, wantGradients);
  return preciseShareOf(corners, wantGradients);
}

/// Adds the share of a triangle over rows of `corners`, which are relative to the point, to `weights`.
inline void addTriangleShare(const Points& corners, const Eigen::RowVector3i& triangle, Values& weights) {
  const auto share =
      shareOfTriangle({corners.row(triangle[0]).transpose(), corners.row(triangle[1]).transpose(),
                       corners.row(triangle[2]).transpose()},
                      false);
  for (int i = 0; share && i < 3; ++i)
    weights[triangle[i]] += share->weights[static_cast<std::size_t>(i)];
}

} // namespace viscera::coordinates
