#pragma once

#include <memory>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::geometry {

/// The signed distance of points from a closed surface: negative inside. A bounding-volume tree over the
/// triangles finds the nearest one; the side is that of the angle-weighted pseudonormal there (Baerentzen and
/// Aanaes, doi 10.1109/TVCG.2005.49), which is right also beside edges and corners. Immutable; thread-safe.
class SignedDistance {
public:
  /// Takes a valid mesh with triangles (`requireValid`), closed and outward, else the sign is meaningless.
  /// Shares ownership of it. O(m log m). Throws `DataError` for a mesh without triangles.
  explicit SignedDistance(std::shared_ptr<const TriangleMesh> mesh);
  ~SignedDistance();

  /// Signed distance of `point` in mm. About O(log m).
  double operator()(const Vec3& point) const;

  /// The point of the surface nearest to `point`. About O(log m).
  Vec3 nearest(const Vec3& point) const;

private:
  struct Branch;
  struct Hit;

  int grow(int begin, int end, const Points& middles);
  Hit find(const Vec3& point) const;
  Vec3 pseudonormal(const Hit& hit) const;

  std::shared_ptr<const TriangleMesh> mesh_;
  std::vector<Branch> branches_;
  std::vector<int> order_;        ///< Triangles as the leaves have them.
  Points vertexNormals_;          ///< `n x 3`, weighted by angles, not unit.
  std::vector<Vec3> edgeNormals_; ///< Three a triangle: opposite to its corners, not unit.
  Points faceNormals_;            ///< `m x 3`, unit or zero.
};

} // namespace viscera::geometry
