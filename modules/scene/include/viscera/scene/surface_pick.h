#pragma once

#include <array>
#include <optional>
#include <vector>

#include "viscera/scene/organ_actor.h"

class vtkRenderer;

namespace viscera::scene {

/// A ray from the eye through a point of the picture.
struct Ray {
  Vec3 origin = Vec3::Zero();     ///< mm.
  Vec3 direction = Vec3::UnitX(); ///< Unit.
};

/// The line of sight through a display position (device pixels from the lower left corner). Right for
/// perspective and parallel cameras.
Ray rayThrough(vtkRenderer* renderer, double x, double y);

/// The place at which a line of sight meets an organ.
struct SurfacePick {
  OrganActor* organ = nullptr;
  int triangle = -1;            ///< Row of the mesh's triangles.
  int vertex = -1;              ///< The nearest corner of that triangle.
  Vec3 position = Vec3::Zero(); ///< mm, on the surface as drawn.
  Vec3 normal =
      Vec3::UnitZ(); ///< Unit, interpolated between the corners' normals; outward for an outward surface.
  std::array<double, 3> weights{}; ///< Barycentric weights of the triangle's corners.
  double distance = 0;             ///< From the ray's origin, mm.
};

/// The nearest visible surface along a ray; surfaces cut away by a clip plane do not count, nor do mere
/// pictures (`SurfaceRole`). O(triangles), on
/// several threads; the same answer whatever their number.
std::optional<SurfacePick> pickSurface(const Ray& ray, const std::vector<OrganActor*>& organs);

} // namespace viscera::scene
