#pragma once

#include <algorithm>
#include <vector>

/// Smooth curves through a few keys, for motions that are known at certain times.
namespace viscera::sequences {

/// One key of a curve.
struct Key {
  double at = 0;
  double value = 0;
};

/// A cubic through keys that never overshoots them: monotone between any two, level at every key that is a
/// local extremum, continuously differentiable. Slopes by Fritsch and Butland (weighted harmonic mean of the
/// neighbouring chords, doi 10.1137/0905021). Immutable; thread-safe.
class Curve {
public:
  /// A curve that starts and ends level and keeps its first and last values outside the keys. `keys` ascend
  /// strictly and are at least two. Throws `DataError` when they do not, or when a number is not finite.
  static Curve through(std::vector<Key> keys);

  /// A curve that repeats itself: `at(x + period) == at(x) + rise`. `keys` ascend strictly within one period
  /// (the last lies before `keys.front().at + period`); one is enough. An uneven clock is such a curve with
  /// `rise == period`. Throws `DataError` as above.
  static Curve periodic(std::vector<Key> keys, double period, double rise = 0);

  /// The value at x. O(log keys).
  double at(double x) const;

  /// The keys from which it was made, in the same order. O(keys).
  std::vector<Key> keys() const;

private:
  struct Knot {
    double at, value, slope;
  };
  /// Where x lies: the knot before it, the length of the span, the place in it (0 to 1) and the rise of whole
  /// periods.
  struct Place {
    const Knot* knot;
    double length, fraction, rise;
  };

  Curve() = default;
  Place find(double x) const;

  std::vector<Knot> knots_; ///< A periodic curve repeats its first knot at the end.
  double period_ = 0;       ///< 0: not periodic.
  double rise_ = 0;
};

/// 0 up to x = 0, 1 from x = 1, and a cubic that is level at both ends in between.
inline double smoothStep(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

} // namespace viscera::sequences
