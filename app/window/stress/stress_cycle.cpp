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

void StressCycle::setWanted(std::optional<live::CycleParts> wanted, double poisson) {
  const bool otherEnergy = std::exchange(poisson_, poisson) != poisson;
  if (std::exchange(wanted_, wanted) != wanted || otherEnergy)
    soon_.start();
}

/// None while there is nothing to compute, or organs are still being bound.
std::optional<StressCycle::Cause> StressCycle::presentCause() const {
  const live::LiveStress& stress = workspace_.stress();
  const live::Player& player = playback_.player();
  if (stress.status().state != live::StressStatus::State::ready || !player.movable() ||
      workspace_.live().busy())
    return std::nullopt;
  return Cause{live::causeOf(player.runner()), stress.gradients(), poisson_};
}

void StressCycle::retry() {
  forgetIfLost();
  soon_.start();
}

/// After a search that was cancelled or failed.
void StressCycle::forgetIfLost() {
  const live::LiveStress& stress = workspace_.stress();
  const bool lacksPeak = parts_ == live::CycleParts::curveAndPeak && stress.cycle() && !stress.cycle()->peak;
  if ((!stress.cycle() || lacksPeak) && !stress.findingCycle())
    cause_.reset();
}

void StressCycle::bringUpToDate() {
  if (!wanted_) { // The result is kept for a return to the same organ and sequence.
    forgetIfLost();
    return;
  }
  std::optional<Cause> cause = presentCause();
  if (cause_ != cause && cause_) {
    cause_.reset();
    workspace_.stress().dropCycle();
  }
  const bool known = cause_ && (parts_ == *wanted_ || parts_ == live::CycleParts::curveAndPeak);
  if (!cause || known)
    return;
  cause_ = std::move(cause);
  parts_ = *wanted_;
  workspace_.guarded([&] {
    live::PosedCycle cycle = live::posedCycle(playback_.player().runner(), workspace_.live().copy());
    cycle.poisson = poisson_;
    workspace_.stress().findCycle(std::move(cycle), parts_);
  });
}

} // namespace viscera::app
