#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <vtkSmartPointer.h>

#include "cli/command.h"
#include "cli/heart_signs.h"
#include "cli/slice_picture.h"
#include "cli/stage_options.h"
#include "viscera/core/phrase.h"
#include "viscera/document/session_file.h"
#include "viscera/presentation/view_state.h"
#include "viscera/sequences/sequence.h"
#include "viscera/workbench/workbench.h"

class vtkImageData;

/// Opens session files for commands.
namespace viscera::app::cli {

/// Describes the contents of a session and lists which of its organs' files were found. Throws as
/// `document::readSession`.
Outcome describeSession(const std::string& file, CommandContext& context);

/// The sequence that a session plays, made again (`live::makeSequence`).
std::shared_ptr<const sequences::Sequence> sequenceOf(const document::DocumentState& state,
                                                      const presentation::ViewState& view,
                                                      CommandContext& context);

/// A workbench with what a command was given.
std::unique_ptr<workbench::Workbench> benchFor(CommandContext& context);

/// A workbench with a session, its organs posed as the view shows them. Throws what binding throws.
std::unique_ptr<workbench::Workbench> posedSession(const document::DocumentState& state,
                                                   const presentation::ViewState& view,
                                                   CommandContext& context);

/// Computes the stress map of the view's current organ, with its course over the sequence that the session
/// was playing. Returns why that is not possible; empty on success.
Text makeStress(workbench::Workbench& bench, const presentation::ViewState& view);

struct SessionPicture {
  vtkSmartPointer<vtkImageData> image;
  std::vector<std::string> leftOut; ///< Sentences for the user about what the window showed and the picture
                                    ///< leaves out.
};

/// The session as the window showed it: looks, pose, the instant of its motion, the influence of a handle or
/// the stress map, and the camera, unless `fromSide` asks for the side of `options`.
SessionPicture sessionPicture(const document::OpenedSession& opened, const StageOptions& options,
                              bool fromSide, CommandContext& context);

/// A beat with the instant that is shown of it.
struct ShownBeat {
  ToldBeat beat;
  double fraction = 0; ///< The part of the cycle that has passed, 0 to 1.
};
/// The beat in whose pose the session's organs were saved; empty when they were in another pose. Makes the
/// sequence again. Throws what reading the view throws.
std::optional<ShownBeat> shownBeat(const document::OpenedSession& opened, CommandContext& context);

/// A slice of the session's scan and organs in the pose that the window showed, with its looks; warped along
/// when it was. `width` 0: level and width are the session's too. Throws as `slicePicture` and what binding
/// throws.
SliceOutcome sessionSlice(const document::OpenedSession& opened, const SliceRequest& slice, double level,
                          double width, const StageOptions& options, CommandContext& context);

} // namespace viscera::app::cli
