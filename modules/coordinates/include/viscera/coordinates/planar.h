#pragma once

#include <string>
#include <vector>

#include "viscera/coordinates/handle_checks.h"
#include "viscera/coordinates/parameters.h"
#include "viscera/core/parallel.h"

namespace viscera::coordinates {

/// The coordinates of points in the plane, and which points failed.
struct PlanarWeights {
  Eigen::MatrixXd weights;   ///< `points x handles`; rows of points without an answer are zero.
  std::vector<int> failures; ///< Points without an answer, ascending.
};

/// The ids that `planarWeights` knows: "s-celestial", "t-celestial", "mean-value", "lagrange-minimisation",
/// "gradient-method", "determinants-approach", "wire-approach".
std::vector<std::string> planarSystems();

/// The coordinates of `points` (`m x 2`) with respect to `handles` (`n x 2`) by the two-dimensional form of a
/// system, with the parameters it has in space; in any unit of length. Triples of a system's form in space
/// are pairs here, and tetrahedra are triangles. "mean-value" takes the handles as the corners of a simple
/// polygon in their order, either way around (Floater 2003, doi 10.1016/S0167-8396(03)00002-5), and has
/// coordinates everywhere; the others have coordinates inside the handles' hull. Throws `UsageError` for an
/// id without a planar form and for parameters as `CoordinateSystem::bind` does, `DataError` for handles that
/// no point could be bound to. Bitwise independent of the number of threads.
PlanarWeights planarWeights(const std::string& system, const PointsOf<2>& handles, const PointsOf<2>& points,
                            const ParameterValues& parameters = {}, Threads threads = {});

} // namespace viscera::coordinates
