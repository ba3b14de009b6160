#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "viscera/geometry/triangle_mesh.h"

namespace viscera::geometry {

/// A closed manifold triangle surface whose edges can be split, collapsed and flipped, each operation refused
/// when it would leave the surface no longer closed, manifold, or folded. Not thread-safe, but `const`
/// members are.
class EditableSurface {
public:
  /// Index of a vertex or a triangle; those of removed ones are not reused.
  using Index = std::int32_t;
  struct Edge {
    Index a = 0, b = 0; ///< a < b
  };

  /// `mesh` must be closed and manifold; `requireClosedManifold` of the caller. O(m).
  explicit EditableSurface(const TriangleMesh& mesh);

  Index vertexCount() const { return static_cast<Index>(points_.size()); }
  /// Triangles that exist.
  int triangleCount() const { return triangleCount_; }
  bool exists(Index vertex) const { return !around_[at(vertex)].empty(); }
  const Vec3& point(Index vertex) const { return points_[at(vertex)]; }
  void movePoint(Index vertex, const Vec3& point) { points_[at(vertex)] = point; }
  const std::vector<Index>& trianglesAround(Index vertex) const { return around_[at(vertex)]; }
  const std::array<Index, 3>& corners(Index triangle) const { return triangles_[at(triangle)]; }
  /// Twice the area, along the outward normal.
  Vec3 doubleArea(Index triangle) const;

  /// The vertices that share an edge with this one.
  std::vector<Index> neighbours(Index vertex) const;

  /// Every edge once, in the order of the triangles.
  std::vector<Edge> edges() const;
  double length2(const Edge& edge) const { return (point(edge.a) - point(edge.b)).squaredNorm(); }

  /// Puts a vertex in the middle of an edge and returns it, or -1 when the edge no longer exists.
  Index split(const Edge& edge);

  /// Merges b into a, placed in the middle or, where that would fold, at an end. Refused (false) when the
  /// link condition fails, when a triangle would turn by more than 60 degrees, or when an edge of the new
  /// vertex would be longer than `longest` mm.
  bool collapse(const Edge& edge, double longest);

  /// Merges b into a, placed at `place`; refused as above, whatever the length of the edges.
  bool collapseTo(const Edge& edge, const Vec3& place);

  /// Flips the edge to the other diagonal when that makes the valences closer to six; refused where the
  /// surface bends across the edge or would fold.
  bool flip(const Edge& edge);

  /// The present state, without what was removed.
  TriangleMesh mesh() const;
  /// The vertices of `mesh()`, in its order.
  std::vector<Index> vertices() const;

private:
  struct Wings {
    std::array<Index, 2> triangle = {-1, -1};
    int count = 0;
  };

  template <class Integer>
  static std::size_t at(Integer index) {
    return static_cast<std::size_t>(index);
  }
  Wings wings(Index a, Index b) const;
  Index opposite(Index triangle, Index a, Index b) const;
  bool staysUnfolded(Index moved, const Vec3& to, const Wings& gone) const;
  bool spokesFit(const Edge& edge, const Vec3& place, double longest) const;
  bool linkAllowsCollapse(const Edge& edge, const Wings& wings) const;
  void merge(const Edge& edge, const Wings& wing, const Vec3& place);
  void detach(Index triangle, Index vertex);

  std::vector<Vec3> points_;
  std::vector<std::array<Index, 3>> triangles_; ///< Removed ones have the corners -1.
  std::vector<std::vector<Index>> around_;      ///< Triangles around each vertex; none around a removed one.
  int triangleCount_ = 0;
};

} // namespace viscera::geometry
