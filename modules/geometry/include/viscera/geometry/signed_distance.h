#pragma once

#include <memory>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/geometry/median_tree.h"
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
  /// Signed distance of `point` in mm. About O(log m).
  double operator()(const Vec3& point) const;

  /// The point of the surface nearest to `point`. About O(log m).
  Vec3 nearest(const Vec3& point) const;

private:
  struct Hit {
    int triangle = -1;
    Vec3 point = Vec3::Zero();
  };

  void grow(const Points& middles);
  Hit find(const Vec3& point) const;
  Vec3 pseudonormal(const Hit& hit) const;

  std::shared_ptr<const TriangleMesh> mesh_;
  MedianTree<Bounds> boxes_;      ///< Of the triangles.
  Points vertexNormals_;          ///< `n x 3`, weighted by angles, not unit.
  std::vector<Vec3> edgeNormals_; ///< Three a triangle: opposite to its corners, not unit.
  Points faceNormals_;            ///< `m x 3`, unit or zero.
};

} // namespace viscera::geometry
