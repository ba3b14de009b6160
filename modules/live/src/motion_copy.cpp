#include "viscera/live/motion_copy.h"

#include <utility>

namespace viscera::live {

MotionCause causeOf(const MotionRunner& runner) {
  const document::DocumentState& state = runner.state();
  MotionCause cause{runner.revision(), state.rig, state.system, {}, {}};
  for (const auto& organ : *state.organs) {
    cause.organs.emplace_back(organ->id, organ->mesh, organ->volumeLocked, organ->mobility);
    if (organ->volumeLocked)
      cause.pose = state.pose;
  }
  return cause;
}

MotionCopy::MotionCopy(const MotionRunner& original, PosedCopy organs)
    : state_(original.state()), organs_(std::move(organs)), runner_(state_, organs_) {
  if (!original.sequence())
    return;
  runner_.setSequence(original.sequence());
  runner_.setRatePerMinute(original.ratePerMinute());
  runner_.prescribe(original.prescribed());
}

PosedCycle posedCycle(const MotionRunner& original, PosedCopy organs) {
  original.requireMovable();
  const double period = original.periodSeconds();
  Points last = organs.shownPose();
  auto copy = std::make_shared<MotionCopy>(original, std::move(organs));
  return {period, [copy, period, last = std::move(last)](double fraction) mutable -> const Points& {
            if (std::optional<Points> pose = copy->runner().poseAt(fraction * period))
              last = std::move(*pose);
            return last;
          }};
}

} // namespace viscera::live
