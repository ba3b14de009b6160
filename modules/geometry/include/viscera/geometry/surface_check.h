#pragma once

#include <string>
#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::geometry {

/// The defects of a triangle surface that matter for an organ (holes, non-manifold edges, wrong orientation),
/// with its area and volume.
struct SurfaceReport {
  int boundaryEdges = 0;    ///< Edges with one triangle: the surface is open there.
  int nonManifoldEdges = 0; ///< Edges with three triangles or more.
  int misorientedEdges = 0; ///< Edges that both their triangles run through in the same direction.
  int degenerateTriangles =
      0;                  ///< Triangles with a repeated vertex or an area below 1e-12 of the squared size.
  int unusedVertices = 0; ///< Vertices of no triangle.
  int components = 0;     ///< Pieces connected through shared vertices.
  double volumeMm3 = 0;   ///< Signed; meaningless when open.
  double areaMm2 = 0;

  bool closed() const { return boundaryEdges == 0; }
  bool manifold() const { return nonManifoldEdges == 0 && misorientedEdges == 0; }
  bool outward() const { return closed() && volumeMm3 > 0; }
};

/// Checks a surface and counts its defects. Expects valid indices (`requireValid`). O(m log m).
SurfaceReport checkSurface(const TriangleMesh& mesh);

/// Describes the defects as sentences for a user ("12 boundary edges: the surface is open"); empty when there
/// are none.
std::vector<Text> faults(const SurfaceReport& report);

/// Turns all triangles around when the signed volume is negative; true when it did. O(m).
bool orientOutward(TriangleMesh& mesh);

} // namespace viscera::geometry
