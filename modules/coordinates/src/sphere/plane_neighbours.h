#pragma once

#include <Eigen/Core>

/// Computes natural neighbour coordinates in a plane, for Voronoi regions on the sphere.
namespace viscera::coordinates {

/// `n x 2` points in a plane.
using PlanePoints = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

/// Natural neighbour coordinates of the origin among `sites` with `powers` (all 0: Sibson's; none above 0):
/// the shares of its cell in the power diagram that it takes from the sites' cells, `sum share_i site_i = 0`.
/// False where its cell is not closed, because the sites do not surround it. O(n^3).
bool planeNeighbours(const PlanePoints& sites, const Eigen::VectorXd& powers, Eigen::VectorXd& shares);

} // namespace viscera::coordinates
