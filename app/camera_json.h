#pragma once

#include <nlohmann/json.hpp>

class vtkRenderer;

namespace viscera::app {

/// The camera of a 3D view as sessions have it (docs/session_format.md).
nlohmann::ordered_json cameraJson(vtkRenderer& renderer);

/// Puts the camera there. One that looks nowhere is left out. Throws nlohmann's exceptions for what is no
/// camera.
void setCamera(const nlohmann::ordered_json& camera, vtkRenderer& renderer);

} // namespace viscera::app
