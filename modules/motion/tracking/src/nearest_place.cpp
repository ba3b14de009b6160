#include "nearest_place.h"

#include <cmath>
#include <limits>
#include <span>

namespace viscera::tracking {
namespace {

constexpr int kTrianglesOfLeaf = 6;

/// The weights of a triangle's corners at its place that is nearest to a point (Ericson, Real-Time Collision
/// Detection, 5.1.5).
Vec3 nearestOfTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a;
  const double d1 = ab.dot(p - a), d2 = ac.dot(p - a);
  if (d1 <= 0 && d2 <= 0)
    return {1, 0, 0};
  const double d3 = ab.dot(p - b), d4 = ac.dot(p - b);
  if (d3 >= 0 && d4 <= d3)
    return {0, 1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0 && d1 > d3)
    return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
  const double d5 = ab.dot(p - c), d6 = ac.dot(p - c);
  if (d6 >= 0 && d5 <= d6)
    return {0, 0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0 && d2 > d6)
    return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  const double va = d3 * d6 - d5 * d4, toC = d4 - d3, toB = d5 - d6;
  if (va <= 0 && toC >= 0 && toB >= 0 && toC + toB > 0)
    return {0, 1 - toC / (toC + toB), toC / (toC + toB)};
  const double sum = va + vb + vc;
  return sum > 0 ? Vec3(va / sum, vb / sum, vc / sum) : Vec3(1, 0, 0);
}

} // namespace

NearestPlace::NearestPlace(const Points& points, const Triangles& triangles)
    : points_(points), triangles_(triangles), middles_(triangles.rows(), 3) {
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    middles_.row(t) =
        (points.row(triangles(t, 0)) + points.row(triangles(t, 1)) + points.row(triangles(t, 2))) / 3;
  const auto boxAround = [&](std::span<const int> items, Vec3& sides) {
    Bounds box{Vec3::Constant(std::numeric_limits<double>::infinity()),
               Vec3::Constant(-std::numeric_limits<double>::infinity())};
    for (const int t : items)
      for (int k = 0; k < 3; ++k) {
        const Vec3 corner = points.row(triangles(t, k));
        box.low = box.low.cwiseMin(corner);
        box.high = box.high.cwiseMax(corner);
      }
    sides = box.high - box.low;
    return box;
  };
  const auto before = [this](int a, int b, Eigen::Index axis) {
    return middles_(a, axis) < middles_(b, axis) || (middles_(a, axis) == middles_(b, axis) && a < b);
  };
  boxes_ =
      geometry::MedianTree<Bounds>(static_cast<int>(triangles.rows()), kTrianglesOfLeaf, boxAround, before);
}

SurfacePlace NearestPlace::of(const Vec3& point) const {
  SurfacePlace best;
  double least = std::numeric_limits<double>::infinity();
  const auto distance = [&](const Bounds& box) {
    return (box.low - point).cwiseMax(point - box.high).cwiseMax(0).squaredNorm();
  };
  const auto skip = [&](const Bounds&, double away) { return away > least; };
  const auto search = [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const Eigen::Index t = boxes_.order()[static_cast<std::size_t>(i)];
      const auto [a, b, c] = geometry::cornersOf(points_, triangles_, t);
      const Vec3 weights = nearestOfTriangle(point, a, b, c);
      const Vec3 at = weights[0] * a + weights[1] * b + weights[2] * c;
      const double apart = (point - at).squaredNorm();
      // Where two are as near, the first one by its number, whatever the order of the tree.
      if (apart < least || (apart == least && t < best.triangle)) {
        least = apart;
        best = {t, weights, at, 0};
      }
    }
  };
  boxes_.searchNearestFirst(distance, skip, search);
  best.apart = std::sqrt(least);
  return best;
}

} // namespace viscera::tracking
