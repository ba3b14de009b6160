#pragma once

#include <array>
#include <optional>
#include <vector>

#include "viscera/core/arrays.h"

namespace viscera::geometry {

/// A bounded convex set of any dimension: a solid, a polygon, a segment or a single point. Intersections of
/// hulls are such sets; two hulls that share a face, an edge or a corner have a flat one. Immutable,
/// thread-safe to read.
///
/// One length, the tolerance, decides what counts as equal, flat or touching; it must be far above rounding
/// and far below the smallest relevant size (1e-9 of the whole scene's diagonal is a good choice).
class ConvexPolytope {
public:
  /// The convex hull of `n x 3` finite points (at least one), mm. O(n log n).
  static ConvexPolytope hullOf(const Points& points, double tolerance);

  /// 0 a point, 1 a segment, 2 a polygon, 3 a solid.
  int dimension() const { return dimension_; }
  const Points& vertices() const { return vertices_; }
  /// Pairs of rows of `vertices()`; a point has one edge from itself to itself.
  const std::vector<std::array<int, 2>>& edges() const { return edges_; }
  /// Triangles that cover the boundary (a solid; outward) or the set (a polygon); none for less.
  const Triangles& triangles() const { return triangles_; }

  /// The largest signed distance to one of the half spaces whose intersection the set is, mm; a lower bound
  /// of the distance outside, at most 0 inside. O(faces).
  double signedDistance(const Vec3& point) const;
  bool contains(const Vec3& point) const { return signedDistance(point) <= tolerance_; }

  /// The point of the set nearest to `point`; `point` itself inside. O(faces).
  Vec3 closestPoint(const Vec3& point) const;

  /// The intersection of both sets, or empty. Sets that touch intersect. O(edges x faces).
  std::optional<ConvexPolytope> intersection(const ConvexPolytope& other) const;

private:
  using Planes = std::vector<Eigen::Vector4d>;

  bool makeSolid(const Points& points);
  void makePolygon(const Points& points, const Eigen::Matrix3d& axes);
  void makeSegment(const Points& points, const Eigen::Matrix3d& axes);
  void makePoint(const Points& points);
  void addSlab(const Vec3& normal);
  void clippedEdges(const ConvexPolytope& by, std::vector<Vec3>& ends) const;

  int dimension_ = 0;
  double tolerance_ = 0;
  Bounds box_; ///< Of the vertices.
  Points vertices_;
  std::vector<std::array<int, 2>> edges_;
  Triangles triangles_;
  Planes planes_; ///< Unit normal and offset: `n.p + offset <= 0` inside.
};

} // namespace viscera::geometry
