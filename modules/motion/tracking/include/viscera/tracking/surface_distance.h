#pragma once

#include <cstddef>
#include <memory>

#include "viscera/core/arrays.h"
#include "viscera/geometry/signed_distance.h"

namespace viscera::tracking {

/// The interface that gives the signed distance of points from the target of a fit, negative inside.
/// Immutable; may be called from several threads.
class SurfaceDistance {
public:
  virtual ~SurfaceDistance() = default;

  /// The distance of a point (mm LPS), mm, and the unit vector along which it grows.
  virtual double at(const Vec3& point, Vec3& direction) const = 0;
  /// About how much memory it takes.
  virtual std::size_t bytes() const = 0;
};

/// The signed distance from a closed, outward surface. O(log m) a point.
class MeshDistance final : public SurfaceDistance {
public:
  /// Keeps the mesh. Throws as `geometry::SignedDistance`.
  explicit MeshDistance(std::shared_ptr<const geometry::TriangleMesh> mesh);

  double at(const Vec3& point, Vec3& direction) const override;
  std::size_t bytes() const override;

private:
  std::shared_ptr<const geometry::TriangleMesh> mesh_;
  geometry::SignedDistance distance_;
};

} // namespace viscera::tracking
