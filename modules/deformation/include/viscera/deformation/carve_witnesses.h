#pragma once

#include <memory>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/deformation/witness_mesh.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::deformation {

/// The mesh without what lies inside `cavities` (blood in a ventricle is no tissue that could be distorted):
/// tetrahedra whose middle is inside one of them go, and points that no tetrahedron needs any more. The rest
/// keeps its order, so witnesses stay first. Unchanged when nothing would be left. O(t log m) on several
/// threads; the same answer whatever their number.
WitnessMesh withoutCavities(const WitnessMesh& mesh,
                            const std::vector<std::shared_ptr<const geometry::TriangleMesh>>& cavities,
                            Threads threads = {});

} // namespace viscera::deformation
