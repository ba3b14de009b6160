#include "green/triangle_potentials.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace viscera::coordinates {
namespace {

/// Of an edge: what the way over its two ends is longer than itself, at least; the logarithm stays finite.
constexpr double kLeastDetour = 1e-30;

} // namespace

SeenTriangle::SeenTriangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  corners_ << a, b, c;
  const Vec3 area = (b - a).cross(c - a);
  normal_ = area.normalized();
  height_ = normal_.dot(a);
  for (int k = 0; k < 3; ++k) {
    const Vec3 edge = corners_.col((k + 1) % 3) - corners_.col(k);
    sideways_.col(k) = edge.cross(normal_).normalized();
    hats_.row((k + 2) % 3) = normal_.cross(edge).transpose() / area.norm();
  }
  foot_ = Vec3::Ones() - (hats_.transpose().cwiseProduct(corners_)).colwise().sum().transpose();
}

bool SeenTriangle::touches(double tolerance) const {
  if (std::abs(height_) > tolerance)
    return false;
  for (int k = 0; k < 3; ++k)
    if (corners_.col(k).dot(sideways_.col(k)) < -tolerance)
      return false;
  return true;
}

TrianglePotentials SeenTriangle::potentials(bool touching, bool wantGradients) const {
  TrianglePotentials result;
  const Vec3 lengths = corners_.colwise().norm().transpose();
  const Vec3 a = corners_.col(0), b = corners_.col(1), c = corners_.col(2);
  if (!touching)
    result.solidAngle = 2 * std::atan2(a.dot(b.cross(c)), lengths.prod() + a.dot(b) * lengths[2] +
                                                              b.dot(c) * lengths[0] + c.dot(a) * lengths[1]);
  Vec3 turned = Vec3::Zero(), ofAngle = Vec3::Zero();
  Eigen::Matrix3d ofLogarithms;
  for (int k = 0; k < 3; ++k) {
    const Vec3 from = corners_.col(k), to = corners_.col((k + 1) % 3);
    const double first = lengths[k], second = lengths[(k + 1) % 3];
    const double edge = (to - from).norm(), beyond = std::max(first + second - edge, kLeastDetour * edge);
    const double logarithm = std::log((first + second + edge) / beyond);
    turned += logarithm * sideways_.col(k);
    result.face += from.dot(sideways_.col(k)) * logarithm;
    if (wantGradients) {
      ofAngle += from.cross(to) * (first + second) / (first * second * (first * second + from.dot(to)));
      ofLogarithms.col(k) = 2 * edge / ((first + second + edge) * beyond) * (from / first + to / second);
    }
  }
  constexpr double kWhole = 4 * std::numbers::pi;
  result.face = (result.face - height_ * result.solidAngle) / kWhole;
  result.corners = (foot_ * result.solidAngle - height_ * (hats_ * turned)) / kWhole;
  if (wantGradients) {
    result.faceGradient = (normal_ * result.solidAngle - turned) / kWhole;
    result.cornerGradients =
        (hats_ * result.solidAngle + foot_ * ofAngle.transpose() + hats_ * turned * normal_.transpose() -
         height_ * hats_ * sideways_ * ofLogarithms.transpose()) /
        kWhole;
  }
  return result;
}

} // namespace viscera::coordinates
