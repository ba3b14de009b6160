#pragma once

#include <vector>

/// Curves of strain over the phases of a cycle.
namespace viscera::strain {

/// A curve's extreme.
struct Peak {
  double value = 0; ///< As the curve: a part, not per cent.
  std::size_t phase = 0;
  double seconds = 0;
};

/// The most negative value of a curve (shortening) and its time; of several equal ones the first. The curve
/// has as many values as there are times, at least one.
Peak shortestOf(const std::vector<double>& curve, const std::vector<double>& seconds);
/// The most positive value (thickening).
Peak longestOf(const std::vector<double>& curve, const std::vector<double>& seconds);

/// The mean of several curves of equal length; values that are not finite are left out. Empty for none.
std::vector<double> meanOf(const std::vector<const std::vector<double>*>& curves);

/// The change against the value at `reference`: `(x - x0) / x0`.
std::vector<double> changeFrom(const std::vector<double>& lengths, std::size_t reference);

/// The standard deviation (n - 1) of numbers; 0 for less than two.
double deviationOf(const std::vector<double>& values);

} // namespace viscera::strain
