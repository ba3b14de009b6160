#pragma once

#include <QObject>

#include <memory>
#include <optional>

#include <nlohmann/json_fwd.hpp>

#include "viscera/presentation/view_state.h"
#include "window/modes/mode_controller.h"
#include "window/timeline/measured_motion.h"
#include "window/timeline/playback.h"
#include "window/view/picture.h"
#include "window/work/workspace.h"

namespace viscera::app {

class Comparison;
class Slides;

/// Saves and restores the view of a session: gathers camera, selection, motions and the second view from the
/// parts of the window into the view's state, and restores a saved state in the window. Theme and panels are
/// not included, because they are settings of the user.
class SessionView final : public QObject {
  Q_OBJECT

public:
  /// The parts of the window; all have to live longer.
  struct Window {
    Workspace& workspace;
    Playback& playback;
    ViewModel& view;
    const Picture& picture;
    ModeController& modes;
    MeasuredMotion& measured;
    Comparison& comparison;
    const Slides& slides;
  };

  explicit SessionView(Window window, QObject* parent = nullptr);

  /// The present view; `shown` as a slide shows it, else with the look from before the slide: a session opens
  /// with that. Motions that are still created, and what waits for them, are in it as they were saved.
  presentation::ViewState state(bool shown = false) const;
  /// The view as a session saves it, with the numbers of a measured motion (docs/session_format.md).
  nlohmann::ordered_json saved() const;
  /// Restores what `saved` made in the window. A worker creates the motions, which are shown when it is done.
  /// Throws `DataError` for what is not such a view, and then changes nothing.
  void apply(const nlohmann::ordered_json& view);
  /// Resets the parts of the view that belong to the closed document: slides, person, cuts and slices.
  void forget();

  const std::vector<presentation::Slide>& slides() const { return window_.view.state().slides; }

Q_SIGNALS:
  void changed();
  /// Emitted when an applied view has no camera.
  void framingWanted();

private:
  struct Wanted;

  void gatherMotions(presentation::ViewState& state) const;
  void gatherWanted(presentation::ViewState& state) const;
  void recallMeasured(const nlohmann::ordered_json& view);
  void makeMotions(Wanted wanted);
  void stopMakingMotions();
  bool stillShows(const Wanted& wanted) const;
  void show(const Wanted& wanted);
  void play(const Wanted& wanted);
  void prescribe(const presentation::Prescribed& prescribed);
  void prescribeWaiting();
  bool takeHandlesOfToday();
  void sayMotionChanged(const QString& how);
  void warnAboutChangedMotion(const Points& saved);

  /// A prescribed volume that is applied once the organs are bound, and its sequence.
  struct Waiting {
    live::PrescribedVolume volume;
    std::shared_ptr<const sequences::Sequence> sequence;
  };

  Window window_;
  std::shared_ptr<const Wanted> making_; ///< What a worker creates the motions of, or null.
  std::optional<Waiting> waiting_;
  Subscription subscription_;
};

} // namespace viscera::app
