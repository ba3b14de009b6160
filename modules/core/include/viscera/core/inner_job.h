#pragma once

#include "viscera/core/progress.h"

namespace viscera {

/// A job inside another one: it is cancelled with the outer one, and its fraction is its own affair. For one
/// thread at a time, and no longer than the outer one lives.
class InnerJob {
public:
  explicit InnerJob(const Progress& outer)
      : progress_([&outer, this](double, const Text&) {
          if (outer.cancelled())
            progress_.cancel();
        }) {}
  Progress& progress() { return progress_; }

private:
  Progress progress_;
};

} // namespace viscera
