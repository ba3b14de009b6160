#pragma once

#include <memory>
#include <vector>

#include "viscera/coordinates/coordinate_system.h"
#include "viscera/core/progress.h"
#include "viscera/elasticity/least_energy.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::live {

/// About so many witness points measure the energy of all organs together, fewer for more than 60 handles:
/// a step of a drag takes time in proportion to witnesses and to the square of the handles.
int energyWitnesses(Eigen::Index handles);

/// The elastic energy of what is inside the surfaces (mm, LPS), for handles that follow. Witness points on
/// grids (`energyWitnesses`), which need no TetGen, are shared out by volume; the tissue of an organ inside
/// another one counts twice. Surfaces that enclose nothing are left out. Takes about a second. Throws
/// `DataError` when none is left or the coordinates are not linear in the pose, `Cancelled`, and what
/// `bindWitnesses` throws.
std::shared_ptr<const elasticity::LeastEnergy>
tissueEnergy(const std::vector<std::shared_ptr<const geometry::TriangleMesh>>& surfaces,
             const coordinates::CoordinateSystem& system, const coordinates::HandleSet& handles,
             const coordinates::BindOptions& options, Progress& progress);

} // namespace viscera::live
