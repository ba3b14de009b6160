#include "planar/planar_mean_value.h"

#include <cmath>

namespace viscera::coordinates {
namespace {

/// Of the polygon's size: a point so near to a corner or an edge lies on it.
constexpr double kOnPolygon = 1e-12;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a[0] * b[1] - a[1] * b[0];
}

} // namespace

bool planarMeanValue(const PointsOf<2>& handles, const Eigen::Vector2d& point, Values& weights) {
  const Eigen::Index count = handles.rows();
  const double size = (handles.colwise().maxCoeff() - handles.colwise().minCoeff()).norm();
  const PointsOf<2> ways = handles.rowwise() - point.transpose();
  const Values distances = ways.rowwise().norm();
  Values halves(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index next = (i + 1) % count;
    const Eigen::Vector2d a = ways.row(i).transpose(), b = ways.row(next).transpose();
    const double length = (b - a).norm(), along = -a.dot(b - a) / length;
    if (std::abs(cross(a, b)) <= kOnPolygon * size * length && along >= -kOnPolygon * size &&
        along <= length + kOnPolygon * size) {
      weights.setZero();
      weights[i] = 1 - along / length;
      weights[next] = along / length;
      return true;
    }
    // tan of half the angle, without a division by zero where the two are opposite.
    halves[i] = (distances[i] * distances[next] - a.dot(b)) / cross(a, b);
    if (cross(a, b) == 0)
      halves[i] = 0; // In line on one side: no angle.
  }
  for (Eigen::Index i = 0; i < count; ++i)
    weights[i] = (halves[(i + count - 1) % count] + halves[i]) / distances[i];
  const double sum = weights.sum();
  if (!(std::abs(sum) > 0))
    return false;
  weights /= sum;
  return true;
}

} // namespace viscera::coordinates
