#pragma once

#include <QObject>
#include <QTimer>

#include <optional>
#include <tuple>

#include "viscera/motion/motion_copy.h"
#include "window/timeline/playback.h"
#include "window/workspace.h"

namespace viscera::app {

/// Has the stress of one view's organ found ahead over the whole cycle of its sequence, on a worker: its
/// curves and its peak are there before a frame was played, and always of the sequence, rate, locks, handles
/// and witness points that there are. What it finds is `live::LiveStress::peak`.
class StressCycle final : public QObject {
  Q_OBJECT

public:
  /// Both have to live longer.
  StressCycle(Workspace& workspace, Playback& playback, QObject* parent = nullptr);

  /// Whether somebody looks at the stress.
  void setWanted(bool wanted);
  /// Looks again where somebody cancelled it.
  void retry();

private:
  /// All that the stress over a cycle depends on.
  struct Cause {
    motion::MotionCause motion;
    std::shared_ptr<const deformation::WitnessGradients> gradients; ///< Of these witnesses on these handles.
    bool operator==(const Cause&) const = default;
  };

  void bringUpToDate();
  std::optional<Cause> presentCause() const;

  Workspace& workspace_;
  Playback& playback_;
  bool wanted_ = false;
  std::optional<Cause> cause_; ///< Of what was found or is being looked for.
  QTimer soon_;                ///< After everybody has heard of a change.
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
