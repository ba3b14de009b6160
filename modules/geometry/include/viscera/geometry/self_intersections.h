#pragma once

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::geometry {

/// The number of pairs of triangles that cross, overlap or touch other than at the vertex or edge that they
/// share. A tree of boxes finds the pairs; each is decided by the signs of determinants; a sign that rounding
/// could have changed (Shewchuk's bound, doi 10.1007/PL00009321) is computed again without rounding, so that
/// triangles of a nearly flat place, whose planes are the same in doubles, do not seem to touch. Triangles
/// without area are left out. Expects valid indices. Independent of the number of threads. Throws
/// `Cancelled`. O(m log m) for a surface that rarely meets itself.
int countSelfIntersections(const TriangleMesh& mesh, Progress& progress, Threads threads = {});

} // namespace viscera::geometry
