#include "view_geometry.h"

#include <algorithm>
#include <cmath>

#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkRenderer.h>

#include "viscera/scene/organ_view.h"

namespace viscera::scene {

ViewGeometry viewGeometry(vtkRenderer* renderer) {
  auto* camera = renderer->GetActiveCamera();
  ViewGeometry view;
  view.eye = Vec3(camera->GetPosition());
  view.forward = Vec3(camera->GetDirectionOfProjection());
  view.right = view.forward.cross(Vec3(camera->GetViewUp())).normalized();
  view.up = view.right.cross(view.forward);
  view.parallel = camera->GetParallelProjection() != 0;
  view.halfHeight = view.parallel ? camera->GetParallelScale()
                                  : std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle()) / 2);
  const int* origin = renderer->GetOrigin();
  const int* size = renderer->GetSize();
  view.centerX = origin[0] + 0.5 * size[0];
  view.centerY = origin[1] + 0.5 * size[1];
  view.pixelHeight = size[1] > 0 ? size[1] : 1;
  view.pixelRatio = pixelRatioOf(renderer->GetRenderWindow());
  return view;
}

DisplayPoint ViewGeometry::project(const Vec3& point) const {
  const Vec3 toPoint = point - eye;
  const double depth = toPoint.dot(forward);
  const double pixelsPerMm = 1 / worldPerPixel(depth);
  return {centerX + toPoint.dot(right) * pixelsPerMm, centerY + toPoint.dot(up) * pixelsPerMm, depth};
}

Vec3 ViewGeometry::unproject(double x, double y, double depth) const {
  const double mmPerPixel = worldPerPixel(depth);
  return eye + depth * forward + (x - centerX) * mmPerPixel * right + (y - centerY) * mmPerPixel * up;
}

Ray ViewGeometry::ray(double x, double y) const {
  if (parallel)
    return {unproject(x, y, 0), forward};
  return {eye, (unproject(x, y, 1) - eye).normalized()};
}

double ViewGeometry::worldPerPixel(double depth) const {
  return 2 * halfHeight * (parallel ? 1 : depth) / pixelHeight;
}

double ViewGeometry::logicalPixel(const Vec3& place) const {
  return pixelRatio * worldPerPixel(std::max((place - eye).dot(forward), 0.0));
}

} // namespace viscera::scene
