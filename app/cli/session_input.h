#pragma once

#include <memory>
#include <string>
#include <vector>

#include <vtkSmartPointer.h>

#include "cli/command.h"
#include "cli/stage_options.h"
#include "viscera/document/session_file.h"
#include "viscera/presentation/view_state.h"
#include "viscera/sequences/sequence.h"

class vtkImageData;

/// What commands make of session files.
namespace viscera::app::cli {

/// What is in a session, with what became of its organs' files. Throws as `document::readSession`.
Outcome describeSession(const std::string& file, Surroundings& surroundings);

/// The sequence that a session plays, made again by its recipe; else the first that it offers, else the one
/// that it has recorded; null for none.
std::shared_ptr<const sequences::Sequence> sequenceOf(const document::DocumentState& state,
                                                      const presentation::ViewState& view,
                                                      Surroundings& surroundings);

struct SessionPicture {
  vtkSmartPointer<vtkImageData> image;
  std::vector<std::string> leftOut; ///< What the window showed and the picture does not, for a user.
};

/// The session as the window showed it: looks, pose, the instant of its motion, the influence of a handle or
/// the stress map, and the camera, unless `fromSide` asks for the side of `options`.
SessionPicture sessionPicture(const document::OpenedSession& opened, const StageOptions& options,
                              bool fromSide, Surroundings& surroundings);

} // namespace viscera::app::cli
