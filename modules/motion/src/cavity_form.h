#pragma once

#include <Eigen/Core>

#include "sample_heart.h"
#include "viscera/coordinates/binding.h"
#include "viscera/deformation/volume_form.h"
#include "viscera/geometry/triangle_mesh.h"
#include "viscera/sample_organs/sample_organ.h"
#include "viscera/sequences/cardiac_cycle.h"

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

/// The same of both cavities of the sample heart. Immutable; thread-safe.
class CavityForms {
public:
  /// Some 0.2 s.
  CavityForms(const sample_organs::SampleOrgan& organ, const SampleHeart& heart, Threads threads);

  sequences::CavityVolumes at(const Points& pose) const { return {left_.at(pose), right_.at(pose)}; }

private:
  CavityForm left_;
  CavityForm right_;
};

} // namespace viscera::motion
