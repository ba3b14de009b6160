#pragma once

#include <string>

#include "window/actions.h"
#include "window/modes/mode_controller.h"
#include "window/stress/stress_model.h"
#include "window/timeline/playback.h"
#include "window/view/view_area.h"
#include "window/workspace.h"

namespace viscera::app {

/// What the window shows beside the document, as the "view" of a session (docs/session_format.md): mode,
/// camera, what is switched on, selection, and the motion at its instant. The theme and the panels are not in
/// it: they are the user's, not the session's.
class ViewState final : public QObject {
  Q_OBJECT

public:
  /// The parts of the window; all have to live longer.
  struct Window {
    Workspace& workspace;
    Playback& playback;
    Actions& actions;
    ViewArea& area;
    StressModel& stress;
    ModeController& modes;
  };

  explicit ViewState(Window window, QObject* parent = nullptr);

  /// The present view: a JSON object.
  std::string gather() const;
  /// Brings the window to that view. What is missing in it stays; motions are made on a worker and shown when
  /// they are there, `applied` then. Throws `DataError` for text that is no such view, with some of it done.
  void apply(const std::string& view);

Q_SIGNALS:
  void applied();

private:
  struct Wanted;

  void makeMotions(const Wanted& wanted);
  void show(const Wanted& wanted);

  Window window_;
};

} // namespace viscera::app
