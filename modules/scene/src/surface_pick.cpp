#include "viscera/scene/surface_pick.h"

#include <limits>

#include "ray_mesh.h"
#include "view_geometry.h"

namespace viscera::scene {

Ray rayThrough(vtkRenderer* renderer, double x, double y) {
  return viewGeometry(renderer).ray(x, y);
}

std::optional<SurfacePick> pickSurface(const Ray& ray, const std::vector<OrganActor*>& organs) {
  std::optional<SurfacePick> pick;
  double farthest = std::numeric_limits<double>::infinity();
  for (auto* organ : organs) {
    if (!organ->met())
      continue;
    const ActorMesh mesh(organ->actor());
    const auto hit = nearestHit(ray, mesh.view(), farthest);
    if (!hit)
      continue;
    farthest = hit->distance;
    pick.emplace();
    pick->organ = organ;
    pick->triangle = static_cast<int>(hit->triangle);
    pick->weights = {1 - hit->u - hit->v, hit->u, hit->v};
    pick->distance = hit->distance;
  }
  if (!pick)
    return pick;

  const auto corners = pick->organ->mesh().triangles.row(pick->triangle);
  Vec3 normal = Vec3::Zero();
  for (int c = 0; c < 3; ++c) {
    pick->position += pick->weights[std::size_t(c)] * pick->organ->points().row(corners[c]).transpose();
    normal +=
        pick->weights[std::size_t(c)] * pick->organ->normals().row(corners[c]).transpose().cast<double>();
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (int c = 0; c < 3; ++c) {
    const double away = (pick->organ->points().row(corners[c]).transpose() - pick->position).norm();
    if (away < nearest) {
      nearest = away;
      pick->vertex = corners[c];
    }
  }
  pick->normal = normal.norm() > 0 ? normal.normalized() : Vec3(-ray.direction);
  return pick;
}

} // namespace viscera::scene
