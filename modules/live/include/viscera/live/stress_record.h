#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/deformation/witness_gradients.h"
#include "viscera/sequences/sequence.h"

namespace viscera::live {

/// The stress of one instant, in one line.
struct StressSample {
  double seconds = 0;
  deformation::StressStatistics statistics;
};

/// Stress over time, for a chart. For one thread.
class StressRecord {
public:
  /// Keeps the last `capacity` samples at least, twice as many at most; 0 keeps all.
  explicit StressRecord(std::size_t capacity = 0) : capacity_(capacity) {}

  /// A time that is not later than the last one (somebody went back) begins a new record.
  void add(const StressSample& sample);
  void clear() { samples_.clear(); }
  const std::vector<StressSample>& samples() const { return samples_; }

private:
  std::size_t capacity_;
  std::vector<StressSample> samples_;
};

/// The worst that every point meets in one cycle of a sequence.
struct StressPeak {
  /// The largest rotational stress, the largest and the smallest stretch, and the volume ratio that is
  /// farthest from 1 (by its factor; one at most 0 before all others) over the cycle, each by itself.
  deformation::StressMap map;
  std::vector<StressSample> cycle; ///< Of the witness points, evenly over the cycle.
  double worstSeconds = 0;         ///< When the rotational stress is largest.
};

/// Goes through one cycle of `sequence` at `ratePerMinute` in `frames` steps, at least 1. Statistics are of
/// the first `witnesses` points. Throws `Cancelled`, `DataError` for a sequence that moves another number of
/// handles. Deterministic; for any thread. O(frames x points x handles).
StressPeak stressPeak(const deformation::WitnessGradients& gradients, Eigen::Index witnesses,
                      const sequences::Sequence& sequence, double ratePerMinute, int frames, Threads threads,
                      Progress& progress);

} // namespace viscera::live
