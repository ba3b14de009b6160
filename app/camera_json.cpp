#include "camera_json.h"

#include <array>

#include <vtkCamera.h>
#include <vtkRenderer.h>

namespace viscera::app {

using nlohmann::ordered_json;
using Numbers = std::array<double, 3>;

ordered_json cameraJson(vtkRenderer& renderer) {
  vtkCamera& camera = *renderer.GetActiveCamera();
  Numbers position, focus, up;
  camera.GetPosition(position.data());
  camera.GetFocalPoint(focus.data());
  camera.GetViewUp(up.data());
  return {{"position", position},
          {"focus", focus},
          {"up", up},
          {"angleDegrees", camera.GetViewAngle()},
          {"parallel", camera.GetParallelProjection() != 0},
          {"parallelScaleMm", camera.GetParallelScale()}};
}

void setCamera(const ordered_json& item, vtkRenderer& renderer) {
  const auto position = item.at("position").get<Numbers>();
  const auto focus = item.at("focus").get<Numbers>();
  const auto up = item.at("up").get<Numbers>();
  if (position == focus)
    return; // It looks nowhere.
  vtkCamera& camera = *renderer.GetActiveCamera();
  camera.SetPosition(position.data());
  camera.SetFocalPoint(focus.data());
  camera.SetViewUp(up.data());
  camera.SetViewAngle(item.value("angleDegrees", camera.GetViewAngle()));
  camera.SetParallelProjection(item.value("parallel", false) ? 1 : 0);
  camera.SetParallelScale(item.value("parallelScaleMm", camera.GetParallelScale()));
  renderer.ResetCameraClippingRange();
}

} // namespace viscera::app
