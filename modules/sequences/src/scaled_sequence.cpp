#include "viscera/sequences/scaled_sequence.h"

#include <cmath>
#include <utility>

#include "viscera/core/error.h"

namespace viscera::sequences {

ScaledSequence::ScaledSequence(std::shared_ptr<const Sequence> standard, double scale)
    : standard_(std::move(standard)), scale_(scale) {
  if (!(scale > 0) || !std::isfinite(scale))
    throw DataError("the size of the organ is not a positive number", standard_->name(),
                    "check the landmarks");
  rest_ = scale_ * standard_->restHandles();
}

void ScaledSequence::poseAt(double seconds, double ratePerMinute, Points& pose) const {
  standard_->poseAt(seconds, ratePerMinute, pose);
  pose *= scale_;
}

} // namespace viscera::sequences
