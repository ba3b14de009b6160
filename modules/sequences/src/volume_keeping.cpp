#include "viscera/sequences/volume_keeping.h"

#include <algorithm>
#include <cmath>

namespace viscera::sequences {
namespace {
constexpr int kScan = 64;
constexpr int kMostSteps = 100;
} // namespace

std::optional<double> solveCubic(const std::array<double, 4>& cubic, double target, double guess, double low,
                                 double high) {
  const auto value = [&](double x) {
    return ((cubic[3] * x + cubic[2]) * x + cubic[1]) * x + (cubic[0] - target);
  };
  const auto slope = [&](double x) { return (3 * cubic[3] * x + 2 * cubic[2]) * x + cubic[1]; };
  // The bracket next to the guess: steps away from it to either side.
  guess = std::clamp(guess, low, high);
  double a = guess;
  double b = guess;
  const double step = (high - low) / kScan;
  bool found = value(guess) == 0;
  for (int k = 1; k <= kScan && !found; ++k) {
    for (const double side : {1.0, -1.0}) {
      const double from = std::clamp(guess + side * (k - 1) * step, low, high);
      const double to = std::clamp(guess + side * k * step, low, high);
      if (found || from == to || value(from) * value(to) > 0)
        continue;
      a = std::min(from, to);
      b = std::max(from, to);
      found = true;
    }
  }
  if (!found)
    return std::nullopt;
  double x = 0.5 * (a + b);
  for (int i = 0; i < kMostSteps && a < b; ++i) {
    const double at = value(x);
    (value(a) * at > 0 ? a : b) = x;
    double next = x - at / slope(x);
    if (!(next > a && next < b))
      next = 0.5 * (a + b);
    if (next == x)
      break;
    x = next;
  }
  return x;
}

} // namespace viscera::sequences
