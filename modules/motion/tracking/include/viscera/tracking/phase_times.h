#pragma once

#include <vector>

#include <Eigen/Core>

/// Tracks a patient's own motion in a series of surfaces or label maps, one for each phase: one rig of
/// handles, a pose a phase. docs/patient_motion.md describes the method.
namespace viscera::tracking {

/// The times of the phases of a series.
struct PhaseTimes {
  std::vector<double> seconds; ///< One for each phase, ascending, all within [0, `periodSeconds`).
  double periodSeconds = 1;
  bool loop = true; ///< Whether the last phase leads back to the first.

  std::size_t count() const { return seconds.size(); }

  /// Phases at equal distances over a whole period: phase `count` would be phase 0 again.
  static PhaseTimes even(std::size_t count, double periodSeconds, bool loop = true);
};

/// The symmetric `t x t` matrix S with `x^T S x = sum |x_(t-1) - 2 x_t + x_(t+1)|^2` for evenly spaced
/// phases; for others the second divided differences times the square of the mean step. Where the series is
/// no loop its ends have no such term. O(t^2).
Eigen::MatrixXd unevenness(const PhaseTimes& times);

/// The neighbours of a phase in time: and the phase's place on the straight way from the one to the other.
struct Neighbours {
  std::size_t before = 0, after = 0;
  double part = 0.5; ///< 0 at `before`, 1 at `after`.
};

/// The neighbours of a phase in time. False where it has only one: an end of a series that is no loop.
bool neighboursOf(const PhaseTimes& times, std::size_t phase, Neighbours& neighbours);

} // namespace viscera::tracking
