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
#include "viscera/core/job_queue.h"
#include "viscera/core/phrase.h"
#include "viscera/document/session_file.h"
#include "viscera/document/undo_stack.h"
#include "viscera/live/live_binding.h"
#include "viscera/live/live_stress.h"
#include "viscera/live/live_warp.h"
#include "viscera/live/motion_runner.h"
#include "viscera/presentation/view_state.h"
#include "viscera/sequences/sequence.h"

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

/// An opened session with its organs bound and posed as they were saved, for commands without an event loop.
class PosedSession {
public:
  /// Poses the organs of `state` as the view shows them. Throws what binding throws.
  PosedSession(const document::DocumentState& state, const presentation::ViewState& view,
               CommandContext& context);
  PosedSession(const PosedSession&) = delete;
  PosedSession& operator=(const PosedSession&) = delete;

  const document::DocumentState& state() const { return document_.state(); }
  live::LiveBinding& organs() { return live_; }
  live::LiveStress& stress() { return stress_; }

  /// The bound deformation of the scan by the pose; null at rest. Throws `DataError` if it cannot be bound.
  live::LiveWarp* makeWarp();
  /// Computes the stress map of the view's current organ, with its course over the sequence that the session
  /// was playing. Returns why that is not possible; empty on success.
  Text makeStress(const presentation::ViewState& view, CommandContext& context);

private:
  void findStressCycle(const presentation::ViewState& view, CommandContext& context);

  document::Document document_;
  document::UndoStack undo_{document_};
  ManualEventLoop box_;
  JobQueue jobs_{box_.post()};
  live::LiveBinding live_;
  live::LiveStress stress_;
  live::LiveWarp warp_;
};

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
