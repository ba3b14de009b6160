#include "camera_fitter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <vtkCamera.h>
#include <vtkRenderer.h>

namespace viscera::scene {
namespace {

/// A little room around the organs that are kept visible.
constexpr double kRoomAround = 1.02;

/// How far a camera is from seeing a box wholly; at most 0 where it does. mm by which it would have to back
/// off, or a parallel one's half height to grow.
double shortOf(const Bounds& box, const ViewGeometry& camera, const CameraFitter::Shape& shape) {
  double most = -std::numeric_limits<double>::infinity();
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 point(corner & 1 ? box.high.x() : box.low.x(), corner & 2 ? box.high.y() : box.low.y(),
                     corner & 4 ? box.high.z() : box.low.z());
    const Vec3 seen = point - camera.eye;
    const double half = kRoomAround * std::max(std::abs(seen.dot(camera.up)) / shape.height,
                                               std::abs(seen.dot(camera.right)) / shape.width);
    // Half heights h at the depth z: h <= H of a parallel camera, h <= (z + back) tan of another.
    most = std::max(most, camera.parallel ? half - camera.halfHeight
                                          : half / camera.halfHeight - seen.dot(camera.forward));
  }
  return most;
}

bool sameCamera(const ViewGeometry& a, const ViewGeometry& b) {
  return a.eye == b.eye && a.forward == b.forward && a.up == b.up && a.parallel == b.parallel &&
         a.halfHeight == b.halfHeight;
}

} // namespace

void CameraFitter::put(vtkRenderer* renderer, const Shape& shape) {
  set_ = left_ = viewGeometry(renderer);
  setShape_ = shape_ = shape;
}

void CameraFitter::follow(vtkRenderer* renderer, const Shape& shape, const std::function<Bounds()>& bounds) {
  if (shape.width <= 0)
    return;
  if (shape_.width <= 0 || !sameCamera(viewGeometry(renderer), left_))
    put(renderer, shape);
  if (std::exchange(shape_, shape) == shape)
    return;
  const Bounds box = bounds();
  const bool whole = shortOf(box, set_, setShape_) <= 0;
  const double back = whole ? std::max(0.0, shortOf(box, set_, shape)) : 0;
  vtkCamera* camera = renderer->GetActiveCamera();
  if (set_.parallel) {
    camera->SetParallelScale(set_.halfHeight + back);
  } else {
    const Vec3 eye = set_.eye - back * set_.forward;
    camera->SetPosition(eye.data());
  }
  renderer->ResetCameraClippingRange();
  left_ = viewGeometry(renderer);
}

} // namespace viscera::scene
