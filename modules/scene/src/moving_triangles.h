#pragma once

#include "viscera/geometry/triangle_mesh.h"

namespace viscera::scene {

/// The triangles with which a surface is drawn while it moves: between about one in `part` of its vertices,
/// and no fewer than some hundreds. Half of a small surface is chosen with care (`vtkDecimatePro`, 4
/// microseconds for each vertex), because it is drawn for as long as a heart beats: rims of vessels stay
/// round. Larger surfaces and smaller parts are clustered (`geometry::coarseTriangles`).
Triangles movingTriangles(const geometry::TriangleMesh& mesh, int part);

} // namespace viscera::scene
