#pragma once

#include "viscera/geometry/triangle_mesh.h"

/// Exact answers by CGAL's bounding-volume trees, for tests only. Link `Viscera::test_support`.
namespace viscera::tests {

/// How far the points (`n x 3`, mm) are from a closed surface at least. Negative, and then the largest
/// trespass, when one is on the wrong side: outside for `insideOf`, inside for `outsideOf`. O(n log m).
double clearanceInsideOf(const geometry::TriangleMesh& surface, const Points& points);
double clearanceOutsideOf(const geometry::TriangleMesh& surface, const Points& points);

} // namespace viscera::tests
