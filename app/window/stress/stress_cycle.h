#pragma once

#include <QObject>
#include <QTimer>

#include <optional>
#include <tuple>

#include "viscera/live/motion_copy.h"
#include "window/timeline/playback.h"
#include "window/work/workspace.h"

namespace viscera::app {

/// Computes the stress of one view's organ over the whole cycle of its sequence, on a worker, before the
/// cycle is played, and again when the sequence, rate, locks, handles or witness points change. The result
/// is `live::LiveStress::cycle`.
class StressCycle final : public QObject {
  Q_OBJECT

public:
  /// Both have to live longer.
  StressCycle(Workspace& workspace, Playback& playback, QObject* parent = nullptr);

  /// Sets what to compute; none: nothing. The maximum takes several times as long as the curves, and its
  /// largest energy is that of Poisson's ratio.
  void setWanted(std::optional<live::CycleParts> wanted, double poisson);
  /// Starts again after the computation was cancelled or has failed.
  void retry();

private:
  /// All that the stress over a cycle depends on.
  struct Cause {
    live::MotionCause motion;
    std::shared_ptr<const deformation::WitnessGradients> gradients; ///< For these witness points and handles.
    double poisson = 0;
    bool operator==(const Cause&) const = default;
  };

  void bringUpToDate();
  void forgetIfLost();
  std::optional<Cause> presentCause() const;

  Workspace& workspace_;
  Playback& playback_;
  std::optional<live::CycleParts> wanted_;
  double poisson_ = elasticity::kUsualPoisson;
  std::optional<Cause> cause_;                       ///< The cause of the result or of the computation under
                                                     ///< way,
  live::CycleParts parts_ = live::CycleParts::curve; ///< and its parts.
  QTimer soon_;                                      ///< Starts the computation after all observers were
                                                     ///< notified of a change.
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
