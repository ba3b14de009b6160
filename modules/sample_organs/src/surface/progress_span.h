#pragma once

#include <string>

#include "viscera/core/progress.h"

namespace viscera::sample_organs {

/// A part of a longer job: 0 to 1 here is `from` to `to` of the whole.
class ProgressSpan {
public:
  ProgressSpan(Progress& whole, double from, double to) : whole_(&whole), from_(from), to_(to) {}

  ProgressSpan part(double from, double to) const { return {*whole_, at(from), at(to)}; }
  void report(double fraction, const std::string& step = {}) const { whole_->report(at(fraction), step); }
  void throwIfCancelled() const { whole_->throwIfCancelled(); }

private:
  double at(double fraction) const { return from_ + fraction * (to_ - from_); }

  Progress* whole_;
  double from_, to_;
};

} // namespace viscera::sample_organs
