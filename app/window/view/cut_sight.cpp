#include "window/view/cut_sight.h"

#include <cmath>

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include "viscera/scene/organ_view.h"

namespace viscera::app {
namespace {

/// The cosine of the angle between sight and normal from which a face is seen well enough to stay.
constexpr double kSeenFace = 0.5;
/// The one to which the camera turns: half way between over the face and along it.
constexpr double kWellSeen = 0.75;
constexpr double kNearlyParallel = 1e-3;

} // namespace

Vec3 sightOfCut(const Vec3& sight, const Vec3& normal) {
  const double along = sight.dot(normal);
  if (along >= kSeenFace)
    return sight;
  Vec3 across = sight - along * normal;
  if (across.norm() < kNearlyParallel) // From straight behind: any side is as good.
    across = normal.unitOrthogonal();
  return kWellSeen * normal + std::sqrt(1 - kWellSeen * kWellSeen) * across.normalized();
}

void seeCut(scene::OrganView& view, const Vec3& normal) {
  vtkCamera& camera = *view.renderer()->GetActiveCamera();
  Vec3 sight, focus, up;
  camera.GetDirectionOfProjection(sight.data());
  const Vec3 wanted = sightOfCut(sight.normalized(), normal);
  if ((wanted - sight.normalized()).norm() < kNearlyParallel)
    return;
  camera.GetFocalPoint(focus.data());
  camera.GetViewUp(up.data());
  Vec3 upright = up - up.dot(wanted) * wanted;
  if (upright.norm() < kNearlyParallel)
    upright = wanted.unitOrthogonal();
  const Vec3 place = focus - camera.GetDistance() * wanted;
  camera.SetPosition(place.x(), place.y(), place.z());
  camera.SetViewUp(upright.normalized().data());
  view.renderer()->ResetCameraClippingRange();
}

} // namespace viscera::app
