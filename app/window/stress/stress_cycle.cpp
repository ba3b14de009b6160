#include "window/stress/stress_cycle.h"

#include <utility>

namespace viscera::app {

StressCycle::StressCycle(Workspace& workspace, Playback& playback, QObject* parent)
    : QObject(parent), workspace_(workspace), playback_(playback) {
  soon_.setSingleShot(true);
  connect(&soon_, &QTimer::timeout, this, &StressCycle::bringUpToDate);
  const auto soon = [this] { soon_.start(); };
  connect(&playback, &Playback::stateChanged, this, soon);
  subscriptions_.push_back(workspace.onChange([soon](const document::Change& change) {
    if (change.organs() || change.rig() || change.system())
      soon();
  }));
  subscriptions_.push_back(workspace.live().onEvent([soon](const live::LiveEvent& event) {
    if (event.status)
      soon();
  }));
  subscriptions_.push_back(workspace.stress().onEvent([soon](const live::StressEvent& event) {
    if (event.status || event.sampled)
      soon();
  }));
}

void StressCycle::setWanted(bool wanted) {
  if (std::exchange(wanted_, wanted) != wanted)
    soon_.start();
}

/// None while there is nothing to find, or organs are still being bound.
std::optional<StressCycle::Cause> StressCycle::presentCause() const {
  const live::LiveStress& stress = workspace_.stress();
  const motion::Player& player = playback_.player();
  if (stress.status().state != live::StressStatus::State::ready || !player.movable() ||
      workspace_.live().busy())
    return std::nullopt;
  return Cause{motion::causeOf(player.runner()), stress.gradients()};
}

void StressCycle::retry() {
  if (!workspace_.stress().peak())
    cause_.reset();
  soon_.start();
}

void StressCycle::bringUpToDate() {
  if (!wanted_) { // Who comes back to the same organ and sequence finds what was there.
    if (!workspace_.stress().peak())
      cause_.reset();
    return;
  }
  std::optional<Cause> cause = presentCause();
  if (cause_ != cause && cause_) {
    cause_.reset();
    workspace_.stress().dropPeak();
  }
  if (!cause || cause_)
    return;
  cause_ = std::move(cause);
  workspace_.guarded([&] {
    workspace_.stress().findPeak(motion::posedCycle(playback_.player().runner(), workspace_.live().copy()));
  });
}

} // namespace viscera::app
