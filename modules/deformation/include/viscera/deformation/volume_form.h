#pragma once

#include <array>
#include <optional>
#include <vector>

#include "viscera/coordinates/binding.h"
#include "viscera/core/progress.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::deformation {

/// The volume of a bound, closed surface as a function of its handles alone.
///
/// Where the points are `p = sum a_i h_i`, the volume `1/6 sum_t det(p1, p2, p3)` (thesis 5.1.1) is by the
/// formula of Cauchy and Binet a sum over triples of handles, `V(H) = sum_{i<j<k} T_ijk det(h_i, h_j, h_k)`,
/// whose coefficients do not depend on the pose. Once they are known, the volume, its gradient and the cubic
/// along any direction cost nothing that grows with the surface: tens of microseconds for 30 handles, where a
/// pass over 172,974 vertices takes milliseconds. Immutable, thread-safe.
class VolumeForm {
public:
  /// Whether a form saves time for a surface that is posed many times: it is made in about a second, and
  /// reading its `handles^3` numbers costs less than reading all coordinates twice, as a gradient on the
  /// surface does.
  static bool pays(Eigen::Index points, Eigen::Index handles);

  /// The form of `rest` (closed) as bound by `binding`. Empty when the points are not linear in the handles
  /// (Green coordinates, points that have no coordinates), which is detected by comparison with the surface
  /// itself in a seeded random pose. Bitwise independent of the number of threads.
  static std::optional<VolumeForm> of(const geometry::TriangleMesh& rest, const coordinates::Binding& binding,
                                      Threads threads = {});
  /// The same, for a worker. Throws `Cancelled`.
  static std::optional<VolumeForm> of(const geometry::TriangleMesh& rest, const coordinates::Binding& binding,
                                      Threads threads, Progress& progress);

  Eigen::Index handles() const { return static_cast<Eigen::Index>(slices_.size()); }

  /// mm^3, at `pose` (`handles x 3`, mm).
  double volume(const Points& pose) const;

  /// Fills `out` (resized to `handles x 3`, mm^2) with the derivative of the volume with respect to the
  /// handles. O(handles^3).
  void gradient(const Points& pose, Points& out) const;

  /// The volume at `pose + s direction` as a cubic in s; constant term first, exact.
  std::array<double, 4> along(const Points& pose, const Points& direction) const;

private:
  explicit VolumeForm(std::vector<Eigen::MatrixXd> slices) : slices_(std::move(slices)) {}

  /// `slices_[i](j, k)` is T_ijk, antisymmetric in all three.
  std::vector<Eigen::MatrixXd> slices_;
};

} // namespace viscera::deformation
