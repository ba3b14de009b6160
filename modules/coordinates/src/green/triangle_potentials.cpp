#include "green/triangle_potentials.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace viscera::coordinates {
namespace {

/// The way over an edge's ends is longer than it by this part, at least; the logarithm stays finite.
constexpr double kLeastDetour = 1e-30;

} // namespace

SeenTriangle::SeenTriangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  corners_ << a, b, c;
  const Vec3 area = (b - a).cross(c - a);
  normal_ = area.normalized();
  height_ = normal_.dot(a);
  // m_k = e_k x n / |e_k| points out of the triangle across edge k. n x e_k / (2 A) is the gradient of the
  // hat function of the opposite corner, 1 over the triangle's height above that edge.
  for (int k = 0; k < 3; ++k) {
    const Vec3 edge = corners_.col((k + 1) % 3) - corners_.col(k);
    sideways_.col(k) = edge.cross(normal_).normalized();
    hats_.row((k + 2) % 3) = normal_.cross(edge).transpose() / area.norm();
  }
  // lambda_k(x) = 1 + grad lambda_k . (x - v_k), at x = 0: the gradients lie in the plane, so the foot h n
  // has the same values.
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
  // Let G = -1 / (4 pi r), r the distance to the origin, 4 pi times what is asked for are the single layer
  // int 1/r dA, and the double layers int lambda_k h / r^3 dA of the hat functions lambda_k, which sum to the
  // solid angle Omega = int h / r^3 dA.
  TrianglePotentials result;
  const Vec3 lengths = corners_.colwise().norm().transpose();
  const Vec3 a = corners_.col(0), b = corners_.col(1), c = corners_.col(2);
  // tan(Omega / 2) = det(a, b, c) / (|a||b||c| + (a.b)|c| + (b.c)|a| + (c.a)|b|).
  if (!touching)
    result.solidAngle = 2 * std::atan2(a.dot(b.cross(c)), lengths.prod() + a.dot(b) * lengths[2] +
                                                              b.dot(c) * lengths[0] + c.dot(a) * lengths[1]);
  Vec3 turned = Vec3::Zero(), ofAngle = Vec3::Zero();
  Eigen::Matrix3d ofLogarithms;
  for (int k = 0; k < 3; ++k) {
    const Vec3 from = corners_.col(k), to = corners_.col((k + 1) % 3);
    const double first = lengths[k], second = lengths[(k + 1) % 3];
    // L_k = int_edge ds / r = ln((r1 + r2 + |e|) / (r1 + r2 - |e|)), with r1 and r2 the distances to its
    // ends. Next to the edge nothing would be left of r1 + r2 - |e| = 2 (r1 r2 + from.to) / (r1 + r2 + |e|),
    // nor of r1 r2 + from.to = |from x to|^2 / (r1 r2 - from.to).
    const double product = first * second, along = from.dot(to), edge = (to - from).norm();
    const double opening = along < 0 ? from.cross(to).squaredNorm() / (product - along) : product + along;
    const double beyond = std::max(2 * opening / (first + second + edge), kLeastDetour * edge);
    const double logarithm = std::log((first + second + edge) / beyond);
    turned += logarithm * sideways_.col(k);
    result.face += from.dot(sideways_.col(k)) * logarithm;
    // The derivatives by the point, for which every corner moves by the opposite. grad Omega = sum_k int_edge
    // (x x dl) / r^3, of an edge (from x to) (r1 + r2) / (r1 r2 (r1 r2 + from.to)); and with s = r1 + r2,
    // dL/ds = -2 |e| / ((s + |e|)(s - |e|)) and grad s = -(from / r1 + to / r2).
    if (wantGradients) {
      ofAngle += from.cross(to) * (first + second) / (product * opening);
      ofLogarithms.col(k) = 2 * edge / ((first + second + edge) * beyond) * (from / first + to / second);
    }
  }
  // int 1/r dA = sum_k (v_k . m_k) L_k - h Omega. For the double layer lambda_k = lambda_k(foot) + grad
  // lambda_k . y, where y = x - h n; since y / r^3 is minus the gradient of 1/r in the plane, Gauss's theorem
  // there makes int y / r^3 dA = -sum_j L_j m_j = -T, and int lambda_k h / r^3 dA = lambda_k(foot) Omega - h
  // grad lambda_k . T.
  constexpr double kWhole = 4 * std::numbers::pi;
  result.face = (result.face - height_ * result.solidAngle) / kWhole;
  result.corners = (foot_ * result.solidAngle - height_ * (hats_ * turned)) / kWhole;
  if (wantGradients) {
    // grad int 1/r dA = int x / r^3 dA = Omega n - T. The double layers' follow by the product rule from grad
    // lambda_k(foot) = grad lambda_k, grad h = -n and grad T = sum_j m_j (grad L_j)^T.
    result.faceGradient = (normal_ * result.solidAngle - turned) / kWhole;
    result.cornerGradients =
        (hats_ * result.solidAngle + foot_ * ofAngle.transpose() + hats_ * turned * normal_.transpose() -
         height_ * hats_ * sideways_ * ofLogarithms.transpose()) /
        kWhole;
  }
  return result;
}

} // namespace viscera::coordinates
