#pragma once

#include "viscera/geometry/triangle_mesh.h"

/// Exact answers by CGAL's polygon mesh processing, for tests only. Link `Viscera::test_support`.
namespace viscera::tests {

/// How many pairs of triangles cross each other or overlap, other than at the vertex or edge that they share.
/// `mesh` must be manifold; throws `std::invalid_argument` otherwise. About a second for 200,000 triangles.
int selfIntersections(const geometry::TriangleMesh& mesh);

/// Whether a triangle of one surface meets one of the other. Both must be manifold.
bool surfacesMeet(const geometry::TriangleMesh& a, const geometry::TriangleMesh& b);

} // namespace viscera::tests
