#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/scene/surface_pick.h"

class vtkActor;

/// Intersects rays with triangle meshes, to find the surface under the mouse.
namespace viscera::scene {

/// The half space `normal . x >= offset` that a clip plane leaves.
struct HalfSpace {
  Vec3 normal = Vec3::UnitZ();
  double offset = 0;
  bool holds(const Vec3& point) const { return normal.dot(point) >= offset; }
};

/// A view of a triangle mesh for ray intersection; it refers to memory that it does not own.
struct MeshView {
  const double* points = nullptr;          ///< `n x 3`
  const std::int32_t* triangles = nullptr; ///< `m x 3`
  Eigen::Index triangleCount = 0;
  std::vector<HalfSpace> clips;

  Vec3 point(Eigen::Index triangle, int corner) const {
    return Eigen::Map<const Vec3>(points + 3 * triangles[3 * triangle + corner]);
  }
};

struct RayHit {
  Eigen::Index triangle = -1;
  double distance = 0; ///< mm from the ray's origin.
  double u = 0;        ///< Barycentric weight of the triangle's second corner,
  double v = 0;        ///< and of the third.
};

/// The nearest triangle that a ray meets, from either side, at a distance in (0, `farthest`). Tests every
/// triangle, because a search tree would have to be rebuilt in every frame for deforming meshes. O(m), on
/// several threads; the lowest triangle wins a tie.
std::optional<RayHit> nearestHit(const Ray& ray, const MeshView& mesh,
                                 double farthest = std::numeric_limits<double>::infinity(),
                                 Threads threads = {});

/// The triangles that an actor draws, for ray intersection. Refers to the memory of the actor's own polygonal
/// data if that consists of double points and 32-bit triangles (as in `OrganActor`); else this object keeps a
/// copy.
class ActorMesh {
public:
  explicit ActorMesh(vtkActor* actor);
  const MeshView& view() const { return view_; }

private:
  MeshView view_;
  std::vector<double> points_;
  std::vector<std::int32_t> triangles_;
};

} // namespace viscera::scene
