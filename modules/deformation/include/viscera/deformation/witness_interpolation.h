#pragma once

#include <cstdint>

#include "viscera/core/parallel.h"
#include "viscera/deformation/witness_mesh.h"

namespace viscera::deformation {

/// Carries numbers at the points of a witness mesh over to other points, say the vertices of the organ's
/// surface: linearly within the tetrahedron that holds the point, and from the nearest one for points just
/// outside. A vertex that is a point of the mesh gets exactly its number. Immutable, thread-safe.
class WitnessInterpolation {
public:
  /// `targets` is `m x 3`, mm. O((m + t) log t). `mesh` has at least one point.
  WitnessInterpolation(const WitnessMesh& mesh, const Points& targets, Threads threads = {});

  Eigen::Index targets() const { return corners_.rows(); }

  /// Fills `result` (resized to `targets`) from `values`, one a point of the mesh. O(m).
  void operator()(const Values& values, Values& result) const;

private:
  Eigen::Matrix<std::int32_t, Eigen::Dynamic, 4, Eigen::RowMajor> corners_;
  Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor> weights_;
};

} // namespace viscera::deformation
