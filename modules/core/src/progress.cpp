#include "viscera/core/progress.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "viscera/core/error.h"

namespace viscera {
namespace {
constexpr double kSmallestStep = 1e-3;
}

Progress::Progress(Listener listener, Look look) : listener_(std::move(listener)), look_(std::move(look)) {}

void Progress::report(double fraction, const Text& step) {
  if (!listener_)
    return;
  const double clamped = std::clamp(fraction, 0.0, 1.0);
  const std::lock_guard lock(mutex_);
  const bool newStep = !step.empty() && !(step == lastStep_);
  if (!newStep && std::abs(clamped - lastFraction_) < kSmallestStep && clamped < 1)
    return;
  lastFraction_ = clamped;
  if (newStep)
    lastStep_ = step;
  listener_(clamped, lastStep_);
}

void Progress::throwIfCancelled() const {
  if (cancelled())
    throw Cancelled();
}

void runPart(Progress& progress, double from, double to, const std::function<void(Progress& part)>& job) {
  progress.throwIfCancelled();
  Progress part(
      [&](double fraction, const Text& step) { progress.report(from + fraction * (to - from), step); });
  part.whole_ = &progress;
  job(part);
  progress.throwIfCancelled();
}

} // namespace viscera
