#pragma once

#include "viscera/geometry/triangle_mesh.h"

namespace viscera::geometry {

/// Simplifies a surface to about `vertices` of its own vertices and returns the triangles between them: they
/// are drawn in place of the surface while it moves too fast for details to be visible. They follow every
/// deformation without a computation of their own, because their corners are the surface's.
///
/// Vertices of one cube of a grid that edges within the cube connect become the one among them that is
/// nearest to their mean; triangles that lose a corner so are left out (Rossignac and Borrel,
/// "Multi-resolution 3D approximations for rendering complex scenes", 1993; the connection keeps the two
/// sides of a thin muscle apart). For drawing only, not for computations: walls may touch.
///
/// Corners are rows of `mesh.points`. All triangles when the mesh has no more vertices than that. Throws
/// `UsageError` for fewer than four vertices. O(n), 0.1 s for a million vertices. The same on any
/// machine.
///
///     Triangles coarse = coarseTriangles(mesh, 25000);
Triangles coarseTriangles(const TriangleMesh& mesh, Eigen::Index vertices);

} // namespace viscera::geometry
