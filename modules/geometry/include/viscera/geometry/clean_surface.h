#pragma once

#include "viscera/geometry/triangle_mesh.h"

namespace viscera::geometry {

/// A surface that was cleaned for mesh generators, with counts of what was changed.
struct CleanedSurface {
  TriangleMesh mesh;        ///< Without colours.
  int mergedPoints = 0;     ///< Points that lay within `kMergeDistance` of the box's diagonal of another.
  int removedTriangles = 0; ///< Zero-area ones, and those that came twice.
  int turnedTriangles = 0;  ///< Turned around to agree with their neighbours, or all of an inside-out one.
  bool changed() const { return mergedPoints + removedTriangles + turnedTriangles > 0; }
};

/// The largest distance of points that are merged, as a fraction of the diagonal of the mesh's box.
inline constexpr double kMergeDistance = 1e-9;

/// Merges coinciding points, removes triangles without area and repeated ones, drops points that no triangle
/// uses, and turns triangles so that neighbours agree (within a piece the larger area wins) and the whole
/// has a positive volume. Holes and intersections stay. Expects valid indices. O(m log m).
CleanedSurface cleanSurface(const TriangleMesh& mesh);

/// Turns triangles around so that neighbours agree (within a piece the larger area wins) and the whole faces
/// outward, an open surface as far as that can be said (about the mean of its points). Points, colours and
/// the order of triangles stay. The number turned. Expects valid indices. O(m log m).
int faceOutward(TriangleMesh& mesh);

/// Simplifies a surface by joining vertices that are in one cell: all points within a cube of edge `cell`
/// (mm) become their mean, and triangles that lose their area are removed. A closed surface stays closed for
/// winding numbers, but may touch itself. O(m).
TriangleMesh clusterVertices(const TriangleMesh& mesh, double cell);

} // namespace viscera::geometry
