#include "viscera/presentation/resection.h"

#include <algorithm>
#include <optional>

#include "viscera/geometry/sides_of_plane.h"

namespace viscera::presentation {
namespace {

constexpr double kMm2PerCm2 = 100;

} // namespace

scene::CutPlane planeOf(const OrganCut& cut, const document::DocumentState& state) {
  std::optional<Bounds> box;
  for (const auto& organ : *state.organs) {
    if (!organ->look.visible)
      continue;
    const Bounds own = boundsOf(organ->mesh->points);
    box = box ? Bounds{box->low.cwiseMin(own.low), box->high.cwiseMax(own.high)} : own;
  }
  if (!box)
    return {Vec3::Zero(), cut.normal};
  const double radius = (box->high - box->low).norm() / 2;
  return {box->center() + cut.offset * radius * cut.normal, cut.normal};
}

std::vector<Resected> resected(const OrganCut& cut, const document::DocumentState& state,
                               const document::PointsOf& pointsOf) {
  const scene::CutPlane plane = planeOf(cut, state);
  std::vector<Resected> found;
  for (const auto& organ : *state.organs) {
    if (!organ->look.visible || !organ->closed())
      continue;
    const geometry::SidesOfPlane sides =
        geometry::sidesOfPlane({&pointsOf(organ->id), &organ->mesh->triangles}, {plane.origin, plane.normal});
    if (sides.cuts())
      found.push_back(
          {organ->id, sides.frontMm3 / kMm3PerMl, sides.backMm3 / kMm3PerMl, sides.faceMm2 / kMm2PerCm2});
  }
  return found;
}

} // namespace viscera::presentation
