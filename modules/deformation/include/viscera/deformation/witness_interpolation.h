#pragma once

#include <cstdint>

#include "viscera/core/parallel.h"
#include "viscera/deformation/witness_mesh.h"

namespace viscera::deformation {

/// Interpolates numbers at the points of a witness mesh at other points, such as the vertices of the organ's
/// surface: linearly within the tetrahedron that holds the point, and from the nearest one for points just
/// outside. A vertex that is a point of the mesh gets exactly its number. Immutable, thread-safe.
class WitnessInterpolation {
public:
  /// `targets` is `m x 3`, mm. O((m + t) log t). `mesh` has at least one point.
  WitnessInterpolation(const WitnessMesh& mesh, const Points& targets, Threads threads = {});

  Eigen::Index targets() const { return corners_.rows(); }

  /// The distance of a target from the place in the mesh whose numbers it gets, mm; 0 inside the mesh.
  double distance(Eigen::Index target) const { return distances_[target]; }
  /// Calls `visit(corner, weight)` for the four points of the mesh that a target's number is made of; the
  /// weights are 0 at least, and 1 together.
  template <class Visit>
  void visitCorners(Eigen::Index target, Visit visit) const {
    for (int k = 0; k < 4; ++k)
      visit(static_cast<Eigen::Index>(corners_(target, k)), weights_(target, k));
  }

  /// Fills `result` (resized to `targets`) from `values`, one for each point of the mesh. O(m).
  void operator()(const Values& values, Values& result) const;

private:
  Eigen::Matrix<std::int32_t, Eigen::Dynamic, 4, Eigen::RowMajor> corners_;
  Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor> weights_;
  Values distances_;
};

} // namespace viscera::deformation
