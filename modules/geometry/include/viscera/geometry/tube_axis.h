#pragma once

#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/geometry/triangle_mesh.h"

/// Computes the centreline of a surface that is roughly a tube: stomach, bowel, vessel.
namespace viscera::geometry {

/// The two ends of a tube as vertices.
struct TubeEnds {
  int wide = 0;   ///< At the end around which there is most surface.
  int narrow = 0; ///< At the end that is farthest from it along the surface.
};

/// Finds the ends of a tube: its tips are the places farther from the rest of the surface than all around
/// them; the tip with most surface near it is the wide end. Side branches (an oesophagus) are tips that are
/// neither. Expects a closed connected surface. O(tips n log n).
TubeEnds tubeEnds(const TriangleMesh& mesh);

/// The tip of the surface nearest to `vertex` along it, of all tips but those close to `other`: where a tube
/// ends beyond a place on it.
int tipBeyond(const TriangleMesh& mesh, int vertex, int other);

/// The centreline of a tube as points, with the areas of its cross-sections.
struct TubeAxis {
  std::vector<Vec3> points;  ///< In order, mm; the first and the last lie on the surface.
  std::vector<double> areas; ///< Of the slice through each point, mm^2; 0 at the ends.
};

/// The centreline from one vertex to another: centres of the slices in which a harmonic function on the
/// surface, 0 around one end and 1 around the other, is constant. A side branch has no end of its own, so the
/// function is constant there and slices leave it out; of several loops the one around the largest area
/// counts. `slices` at least 8. Deterministic. Throws `DataError` when the two are one place or not on one
/// piece of the surface. A sparse factorisation, O(n^1.5).
TubeAxis tubeAxis(const TriangleMesh& mesh, int from, int to, int slices = 48);

} // namespace viscera::geometry
