#pragma once

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::geometry {

/// How many pairs of triangles cross, overlap or touch other than at the vertex or edge that they share. A
/// tree of boxes finds the pairs; each is decided by the signs of determinants; one that rounding could have
/// made (Shewchuk's bound, doi 10.1007/PL00009321) is taken anew without rounding, so that triangles of a
/// nearly flat place, whose planes cannot be told apart in doubles, do not seem to touch. Triangles without
/// area are left out. Expects valid indices. Independent of the number of threads. Throws `Cancelled`. O(m
/// log m) for a surface that rarely meets itself.
int countSelfIntersections(const TriangleMesh& mesh, Progress& progress, Threads threads = {});

} // namespace viscera::geometry
