#pragma once

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/deformation/witness_mesh.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::deformation {

/// Witness points on a regular grid inside `surface`, which may have defects: inside is where its winding
/// number is above one half. Every grid cell is cut into six tetrahedra (Kuhn's), of which those with all
/// corners inside are kept; all points are witnesses. The spacing is chosen so that the number of points is
/// within 5 % of `wanted`, or as near as the shape allows. Throws `DataError` for a surface that encloses
/// nothing, `Cancelled`. O(wanted log m). Bitwise independent of the number of threads.
WitnessMesh gridWitnesses(const geometry::TriangleMesh& surface, int wanted, Progress& progress,
                          Threads threads = {});

} // namespace viscera::deformation
