#pragma once

#include <string>

#include <vtkSmartPointer.h>

#include "cli/command.h"
#include "cli/stage.h"
#include "viscera/session/session_file.h"

class vtkImageData;

/// What commands make of session files.
namespace viscera::app::cli {

/// What is in a session, with what became of its organs' files. Throws as `session::readSession`.
Outcome describeSession(const std::string& file, Surroundings& surroundings);

/// The session as the window showed it: looks, pose, the instant of its motion, and the camera, unless
/// `fromSide` asks for the side of `options`. Maps of stress and influence are left out.
vtkSmartPointer<vtkImageData> sessionPicture(const session::OpenedSession& opened,
                                             const StageOptions& options, bool fromSide,
                                             Surroundings& surroundings);

} // namespace viscera::app::cli
