#pragma once

#include <vector>

#include "viscera/geometry/triangle_mesh.h"

namespace viscera::geometry {

/// The connected pieces of a surface, joined through shared vertices.
struct ConnectedPieces {
  int count = 0;
  std::vector<int>
      ofVertex; ///< 0 to count - 1 in order of their first vertices; -1 for a vertex without triangles.
};

/// Finds the connected pieces of a valid mesh. O(n + m).
ConnectedPieces connectedPieces(const TriangleMesh& mesh);

/// The area of every piece, mm^2. O(m).
std::vector<double> areasOf(const ConnectedPieces& pieces, const TriangleMesh& mesh);

/// The piece with the largest area alone, with its colours, points and triangles in their order. O(n + m).
TriangleMesh largestPiece(const TriangleMesh& mesh);

} // namespace viscera::geometry
