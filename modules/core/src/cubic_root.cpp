#include "viscera/core/cubic_root.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace viscera {
namespace {

constexpr int kMostBisections = 200;

double valueAt(const std::array<double, 4>& c, double s) {
  return c[0] + s * (c[1] + s * (c[2] + s * c[3]));
}

double slopeAt(const std::array<double, 4>& c, double s) {
  return c[1] + s * (2 * c[2] + s * 3 * c[3]);
}

/// Where the cubic turns between 0 and `end`, ascending in |s|.
std::vector<double> turningPoints(const std::array<double, 4>& c, double end) {
  // 3 c_3 s^2 + 2 c_2 s + c_1 = 0.
  const double a = 3 * c[3], b = 2 * c[2], d = c[1];
  std::vector<double> turns;
  const double discriminant = b * b - 4 * a * d;
  if (discriminant < 0)
    return turns;
  // The form without cancellation: one root from the larger of -b +- sqrt, the other from the product of the
  // roots.
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  for (const double root : {a != 0 ? q / a : INFINITY, q != 0 ? d / q : INFINITY})
    if (std::isfinite(root) && root * end > 0 && std::abs(root) < std::abs(end))
      turns.push_back(root);
  std::sort(turns.begin(), turns.end(), [](double x, double y) { return std::abs(x) < std::abs(y); });
  return turns;
}

/// Newton's method kept inside a bracket on which the cubic is monotone and changes sign.
double rootBetween(const std::array<double, 4>& c, double low, double high) {
  const bool rising = valueAt(c, high) > valueAt(c, low);
  double s = 0.5 * (low + high);
  for (int i = 0; i < kMostBisections; ++i) {
    const double value = valueAt(c, s);
    if (value == 0)
      return s;
    ((value > 0) == rising ? high : low) = s;
    const double slope = slopeAt(c, s);
    double next = slope != 0 ? s - value / slope : low;
    if (!(std::min(low, high) < next && next < std::max(low, high)))
      next = 0.5 * (low + high);
    if (next == s)
      return s;
    s = next;
  }
  return s;
}

std::optional<double> firstRootTowards(const std::array<double, 4>& c, double end) {
  std::vector<double> stops = turningPoints(c, end);
  stops.push_back(end);
  double from = 0;
  for (const double to : stops) {
    const double a = valueAt(c, from), b = valueAt(c, to);
    if (a == 0)
      return from;
    if (b == 0)
      return to;
    if ((a > 0) != (b > 0))
      return rootBetween(c, from, to);
    from = to;
  }
  return std::nullopt;
}

} // namespace

std::optional<double> nearestCubicRoot(const std::array<double, 4>& c, double low, double high) {
  const auto up = firstRootTowards(c, high);
  const auto down = firstRootTowards(c, low);
  if (!up)
    return down;
  if (!down)
    return up;
  return std::abs(*up) <= std::abs(*down) ? up : down;
}

} // namespace viscera
