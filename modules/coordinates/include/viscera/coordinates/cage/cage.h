#pragma once

#include <string>
#include <vector>

#include "viscera/coordinates/handle_set.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::coordinates {

/// The closed, outward triangles over the handles that a cage system works with: the rig's own cage, else the
/// convex hull of the handles (whose inner handles then have no influence). Throws `DataError` for a cage
/// whose triangles name handles that do not exist, for one that is open or not manifold (with the number of
/// edges), and, without a cage, for handles that are all in one plane. For any thread. O(n log n).
Triangles cageOf(const HandleSet& handles);

/// Throws `DataError` for a surface that cannot be a cage: without triangles, with indices out of range,
/// open, or not manifold (with the number of edges). `where` names the cage in the message. O(m log m).
void requireCage(const geometry::TriangleMesh& cage, const Text& where = "the cage");

/// Gives for every vertex of a cage (mm) the handle (`n x 3`, mm) at it, to 1e-6 of the cage's size; -1
/// where there is none. O(n v).
std::vector<int> handlesAtVertices(const Points& handles, const geometry::TriangleMesh& cage);

/// The triangles of a given cage (mm) over the handles (`n x 3`, mm) that lie at its vertices, for
/// `HandleSet::cage`, outward. Handles that lie at no vertex get no triangle. Throws as `requireCage`, and
/// `DataError` that names the first vertex where no handle is (to 1e-6 of the cage's size). O(n v).
Triangles cageOver(const Points& handles, const geometry::TriangleMesh& cage);

} // namespace viscera::coordinates
