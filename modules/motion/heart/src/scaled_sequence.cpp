#include "viscera/heart/scaled_sequence.h"

#include <cmath>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::heart {

ScaledSequence::ScaledSequence(std::shared_ptr<const sequences::Sequence> standard, double scale)
    : standard_(std::move(standard)), scale_(scale) {
  if (!(scale > 0) || !std::isfinite(scale))
    throw DataError(misuse("the size of the organ is not a positive number"), standard_->name(),
                    "check the landmarks");
  rest_ = scale_ * standard_->restHandles();
}

void ScaledSequence::poseAt(double seconds, double ratePerMinute, Points& pose) const {
  standard_->poseAt(seconds, ratePerMinute, pose);
  pose *= scale_;
}

std::optional<CardiacBeat> ScaledSequence::textbookBeat(double ratePerMinute) const {
  return standard_->heart()->textbookBeat(ratePerMinute);
}

std::optional<ValveInstants> ScaledSequence::valves(double seconds, double ratePerMinute) const {
  std::optional<ValveInstants> valves = standard_->heart()->valves(seconds, ratePerMinute);
  if (valves)
    for (ValveInstant& valve : *valves) {
      valve.areaMm2 *= scale_ * scale_;
      valve.flowMlPerS *= scale_ * scale_ * scale_;
    }
  return valves;
}

std::optional<BeatClock> ScaledSequence::clock(double seconds, double ratePerMinute) const {
  return standard_->heart()->clock(seconds, ratePerMinute);
}

std::optional<HeartFrame> ScaledSequence::frame() const {
  const std::optional<HeartFrame> frame = standard_->heart()->frame();
  if (!frame)
    return std::nullopt;
  return HeartFrame(scale_ * frame->origin(), frame->towardsRight(), frame->towardsApex());
}

} // namespace viscera::heart
