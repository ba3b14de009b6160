#pragma once

#include <array>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::geometry {

/// The signed distances from a surface at the nodes of a regular grid, negative inside.
struct SignedDistanceGrid {
  std::array<int, 3> size = {0, 0, 0}; ///< Nodes along x, y, z.
  Vec3 origin = Vec3::Zero();          ///< The first node, mm.
  double spacing = 0;                  ///< mm.
  std::vector<float> values;           ///< mm, x fastest; cut off at `kDistanceBand` spacings.
};

/// Distances beyond this many spacings are not measured.
inline constexpr int kDistanceBand = 3;

/// Distances on a grid around `surface`, four nodes wider than its box. A node is inside where the surface's
/// winding number is above one half; so holes are closed and parts that intersect are united. Expects valid
/// indices; throws `DataError` when the grid would have more than 3e7 nodes, `Cancelled`. O(nodes log m +
/// triangles x the nodes near them). Bitwise independent of the number of threads.
SignedDistanceGrid signedDistanceGrid(const TriangleMesh& surface, double spacing, Progress& progress,
                                      Threads threads = {});

/// Averages every value with its neighbours, weights 1 2 1 along each axis, `rounds` times: smooths the steps
/// at closed holes.
void smoothen(SignedDistanceGrid& grid, int rounds, Threads threads = {});

} // namespace viscera::geometry
