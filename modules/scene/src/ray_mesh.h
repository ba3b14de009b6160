#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/scene/surface_pick.h"

class vtkActor;

namespace viscera::scene {

/// The half space `normal . x >= offset` that a clip plane leaves.
struct HalfSpace {
  Vec3 normal = Vec3::UnitZ();
  double offset = 0;
  bool holds(const Vec3& point) const { return normal.dot(point) >= offset; }
};

/// Triangles to shoot at; looks at somebody else's memory.
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

/// The nearest triangle that a ray meets, from either side, at a distance in (0, `farthest`). Looks at every
/// triangle: deforming meshes would spoil a search tree in every frame. O(m), on several threads; the lowest
/// triangle wins a tie.
std::optional<RayHit> nearestHit(const Ray& ray, const MeshView& mesh,
                                 double farthest = std::numeric_limits<double>::infinity(),
                                 Threads threads = {});

/// What an actor draws, as triangles to shoot at. Uses the memory of the actor's own polygonal data when that
/// is double points and 32-bit triangles (as `OrganActor` has it); else a copy is kept in this object.
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
