#pragma once

#include <Eigen/Core>

#include "viscera/coordinates/binding.h"
#include "viscera/deformation/volume_form.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::motion {

/// The volume of a bound cavity in microseconds. Of the many handles around a heart a smooth cavity feels few
/// combinations: those that the weights' singular values say matter, and the volume is a cubic form in them
/// (`deformation::VolumeForm`). Immutable; thread-safe.
class CavityForm {
public:
  /// Throws `DataError` when the points are not linear in the handles. Some 0.1 s.
  CavityForm(const geometry::TriangleMesh& rest, const coordinates::Binding& binding, Threads threads);

  /// With the handles at `pose` (`n x 3`), ml; within 0.002 ml of the surface's own volume in the poses of a
  /// beating heart.
  double at(const Points& pose) const;
  /// How many combinations there are.
  Eigen::Index combinations() const { return basis_.cols(); }

private:
  Eigen::MatrixXd basis_; ///< `handles x combinations`, orthonormal.
  deformation::VolumeForm form_;
};

} // namespace viscera::motion
