#include "viscera/sequences/curve.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::sequences {
namespace {

void requireKeys(const std::vector<Key>& keys, std::size_t fewest) {
  if (keys.size() < fewest)
    throw DataError(misuse("a curve needs at least %n {key|keys}", fewest), "curve");
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (!std::isfinite(keys[i].at) || !std::isfinite(keys[i].value))
      throw DataError(misuse("the key is not a finite number"), phrase("curve key %1", i + 1));
    if (i > 0 && keys[i].at <= keys[i - 1].at)
      throw DataError(misuse("the key does not lie after the one before it"), phrase("curve key %1", i + 1),
                      misuse("sort the keys and remove doubles"));
  }
}

/// The slope at a knot between two chords: 0 at an extremum, else their weighted harmonic mean.
double monotoneSlope(double lengthBefore, double chordBefore, double lengthAfter, double chordAfter) {
  if (chordBefore * chordAfter <= 0)
    return 0;
  // (w_1 + w_2) / (w_1 / c_1 + w_2 / c_2) with w_1 = h_1 + 2 h_2 and w_2 = 2 h_1 + h_2: of the one sign of
  // both chords and below three times the flatter one, which keeps the cubic monotone.
  const double weightBefore = lengthBefore + 2 * lengthAfter;
  const double weightAfter = 2 * lengthBefore + lengthAfter;
  return (weightBefore + weightAfter) / (weightBefore / chordBefore + weightAfter / chordAfter);
}

} // namespace

Curve Curve::through(std::vector<Key> keys) {
  requireKeys(keys, 2);
  Curve curve;
  for (const Key& key : keys)
    curve.knots_.push_back({key.at, key.value, 0});
  for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
    const double before = keys[i].at - keys[i - 1].at;
    const double after = keys[i + 1].at - keys[i].at;
    curve.knots_[i].slope = monotoneSlope(before, (keys[i].value - keys[i - 1].value) / before, after,
                                          (keys[i + 1].value - keys[i].value) / after);
  }
  return curve;
}

Curve Curve::periodic(std::vector<Key> keys, double period, double rise) {
  requireKeys(keys, 1);
  if (!std::isfinite(rise) || !(period > keys.back().at - keys.front().at))
    throw DataError(misuse("the keys do not fit into one period"), "curve",
                    misuse("give keys of one period only"));
  Curve curve;
  curve.period_ = period;
  curve.rise_ = rise;
  keys.push_back({keys.front().at + period, keys.front().value + rise});
  const std::size_t spans = keys.size() - 1;
  const auto length = [&](std::size_t i) { return keys[i + 1].at - keys[i].at; };
  const auto chord = [&](std::size_t i) { return (keys[i + 1].value - keys[i].value) / length(i); };
  for (std::size_t i = 0; i <= spans; ++i) {
    const std::size_t before = (i + spans - 1) % spans;
    const std::size_t after = i % spans;
    const double slope = monotoneSlope(length(before), chord(before), length(after), chord(after));
    curve.knots_.push_back({keys[i].at, keys[i].value, slope});
  }
  return curve;
}

Curve::Place Curve::find(double x) const {
  double rise = 0;
  if (period_ > 0) {
    const double turns = std::floor((x - knots_.front().at) / period_);
    x -= turns * period_;
    rise = turns * rise_;
  }
  x = std::clamp(x, knots_.front().at, knots_.back().at);
  const auto next = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, x,
                                     [](double value, const Knot& knot) { return value < knot.at; });
  const Knot& knot = *(next - 1);
  const double length = next->at - knot.at;
  return {&knot, length, (x - knot.at) / length, rise};
}

std::vector<Key> Curve::keys() const {
  std::vector<Key> keys;
  const std::size_t repeated = period_ > 0 ? 1 : 0;
  for (std::size_t i = 0; i + repeated < knots_.size(); ++i)
    keys.push_back({knots_[i].at, knots_[i].value});
  return keys;
}

double Curve::at(double x) const {
  // Hermite's cubic, with v = 1 - u: v^2 ((1 + 2 u) y_0 + u h y_0') + u^2 ((1 + 2 v) y_1 - v h y_1').
  const auto [knot, length, u, rise] = find(x);
  const Knot& next = knot[1];
  const double v = 1 - u;
  return rise + v * v * ((1 + 2 * u) * knot->value + u * length * knot->slope) +
         u * u * ((1 + 2 * v) * next.value - v * length * next.slope);
}

} // namespace viscera::sequences
