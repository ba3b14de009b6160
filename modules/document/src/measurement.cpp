#include "viscera/document/measurement.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/document/organ.h"

namespace viscera::document {
namespace {

constexpr const char* kMeasurementNames[] = {"distance", "angle", "rectangle", "sphere", "gap"};
/// How far weights may be from a place in the triangle before they are taken for wrong.
constexpr double kPlaceTolerance = 1e-6;

using Corners = Eigen::Matrix3d; ///< One a column.

Corners cornersOf(const Triangles& triangles, const Points& points, Eigen::Index triangle) {
  Corners corners;
  for (int k = 0; k < 3; ++k)
    corners.col(k) = points.row(triangles(triangle, k)).transpose();
  return corners;
}

/// The weights of the point of the segment from corner `a` to corner `b` that is nearest to `place`.
Vec3 nearestOnEdge(const Corners& corners, int a, int b, const Vec3& place) {
  const Vec3 along = corners.col(b) - corners.col(a);
  const double square = along.squaredNorm();
  const double t = square > 0 ? std::clamp((place - corners.col(a)).dot(along) / square, 0.0, 1.0) : 0;
  Vec3 weights = Vec3::Zero();
  weights[a] = 1 - t;
  weights[b] = t;
  return weights;
}

/// The weights of the point of a triangle that is nearest to `place`: the foot of the perpendicular where it
/// lies inside, else on one of the edges. Also for triangles without area.
Vec3 nearestInTriangle(const Corners& corners, const Vec3& place) {
  const Vec3 u = corners.col(1) - corners.col(0);
  const Vec3 v = corners.col(2) - corners.col(0);
  const Vec3 normal = u.cross(v);
  const double square = normal.squaredNorm();
  if (square > 0) {
    // b_1 = (w x v) . n / |n|^2 and b_2 = (u x w) . n / |n|^2, with n = u x v.
    const Vec3 w = place - corners.col(0);
    const double second = w.cross(v).dot(normal) / square;
    const double third = u.cross(w).dot(normal) / square;
    if (second >= 0 && third >= 0 && second + third <= 1)
      return {1 - second - third, second, third};
  }
  Vec3 best = nearestOnEdge(corners, 0, 1, place);
  for (const auto& [a, b] : {std::pair{1, 2}, std::pair{2, 0}}) {
    const Vec3 other = nearestOnEdge(corners, a, b, place);
    if ((corners * other - place).squaredNorm() < (corners * best - place).squaredNorm())
      best = other;
  }
  return best;
}

} // namespace

std::size_t pointCount(MeasurementKind kind) {
  return kind == MeasurementKind::angle ? 3 : 2;
}

bool isRegion(MeasurementKind kind) {
  return kind == MeasurementKind::rectangle || kind == MeasurementKind::sphere;
}

bool isLength(MeasurementKind kind) {
  return kind == MeasurementKind::distance || kind == MeasurementKind::gap;
}

std::string nameOf(MeasurementKind kind) {
  return kMeasurementNames[static_cast<std::size_t>(kind)];
}

std::optional<MeasurementKind> measurementKindFromName(const std::string& name) {
  for (std::size_t i = 0; i < std::size(kMeasurementNames); ++i)
    if (name == kMeasurementNames[i])
      return static_cast<MeasurementKind>(i);
  return std::nullopt;
}

MeasuredPoint surfacePoint(const Organ& organ, int triangle, const Vec3& weights) {
  if (triangle < 0 || triangle >= organ.mesh->triangles.rows())
    throw DataError(misuse("there is no triangle %1", triangle), named(organ.name),
                    "pick the point on the surface again");
  if (!(weights.minCoeff() >= -kPlaceTolerance && std::abs(weights.sum() - 1) <= kPlaceTolerance))
    throw DataError(misuse("barycentric weights must be at least 0 and sum to 1"), named(organ.name),
                    "pick the point on the surface again");
  MeasuredPoint point;
  point.organ = organ.id;
  point.triangle = triangle;
  point.weights = weights.cwiseMax(0.0);
  point.weights /= point.weights.sum();
  point.rest = cornersOf(organ.mesh->triangles, organ.mesh->points, triangle) * point.weights;
  return point;
}

MeasuredPoint nearestPoint(const Organ& organ, const Vec3& place) {
  const Triangles& triangles = organ.mesh->triangles;
  double nearest = std::numeric_limits<double>::infinity();
  int triangle = 0;
  Vec3 weights = Vec3::UnitX();
  for (Eigen::Index i = 0; i < triangles.rows(); ++i) {
    const Corners corners = cornersOf(triangles, organ.mesh->points, i);
    const Vec3 found = nearestInTriangle(corners, place);
    const double away = (corners * found - place).squaredNorm();
    if (away < nearest) {
      nearest = away;
      triangle = static_cast<int>(i);
      weights = found;
    }
  }
  return surfacePoint(organ, triangle, weights);
}

} // namespace viscera::document
