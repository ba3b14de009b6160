#include "viscera/scene/surface_pick.h"

#include <algorithm>

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
    if (!organ->visible())
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
  const auto heaviest = std::max_element(pick->weights.begin(), pick->weights.end());
  pick->vertex = corners[heaviest - pick->weights.begin()];
  pick->normal = normal.norm() > 0 ? normal.normalized() : Vec3(-ray.direction);
  return pick;
}

} // namespace viscera::scene
