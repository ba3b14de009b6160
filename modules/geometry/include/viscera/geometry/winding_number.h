#pragma once

#include <memory>

#include "viscera/geometry/triangle_mesh.h"

namespace viscera::geometry {

/// Computes the winding number, the number of times that a surface winds around a point: 1 inside and 0
/// outside of a closed one. For an open or self-intersecting surface the number passes smoothly from one to
/// the other across a hole, so "above one half" is a sound answer to "inside?" where no exact one exists
/// (Jacobson et al. 2013, doi:10.1145/2461912.2461916). Far triangles are taken together as one dipole, as by
/// Barill et al. 2018, doi:10.1145/3197517.3201337. Immutable; may be called from several threads.
class WindingNumber {
public:
  /// Copies what it needs of `mesh`, whose indices and coordinates are valid. O(m log m).
  explicit WindingNumber(const TriangleMesh& mesh);
  ~WindingNumber();
  WindingNumber(WindingNumber&&) noexcept;
  WindingNumber& operator=(WindingNumber&&) noexcept;

  /// The number at `point` (mm), to about 0.01; on the surface itself anything between its two sides.
  /// O(log m), about a microsecond.
  double operator()(const Vec3& point) const;

  /// Whether the surface goes around `point` more than half.
  bool inside(const Vec3& point) const { return (*this)(point) > 0.5; }

private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

} // namespace viscera::geometry
