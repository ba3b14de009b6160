#include "viscera/circulation/valve_state.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace viscera::circulation {
namespace {

/// An instant at which a valve opens or shuts.
struct Crossing {
  double seconds = 0;
  bool opens = false;
};

std::vector<Crossing> crossingsOf(const Beat& beat, const std::vector<double>& open) {
  std::vector<Crossing> crossings;
  for (std::size_t i = 1; i < open.size(); ++i) {
    if (isOpen(open[i - 1]) == isOpen(open[i]))
      continue;
    const double from = open[i - 1] - kTouching, to = open[i] - kTouching;
    // from + s (to - from) = 0 at s = from / (from - to).
    crossings.push_back(
        {beat.time[i - 1] + (beat.time[i] - beat.time[i - 1]) * from / (from - to), isOpen(open[i])});
  }
  return crossings;
}

double withinBeat(double seconds, double period) {
  return seconds - period * std::floor(seconds / period);
}

} // namespace

double openSeconds(const ValveTimes& times, double period) {
  return withinBeat(times.shuts - times.opens, period);
}

std::vector<ValveTimes> openTimes(const Beat& beat, Valve valve) {
  const std::vector<Crossing> crossings = crossingsOf(beat, beat.openOf(valve));
  std::vector<ValveTimes> times;
  for (std::size_t i = 0; i < crossings.size(); ++i)
    if (crossings[i].opens)
      times.push_back({crossings[i].seconds, crossings[(i + 1) % crossings.size()].seconds});
  return times;
}

double bothShutSeconds(const ValveTimes& first, const ValveTimes& second, double period) {
  const double after = withinBeat(second.opens - first.shuts, period);
  return after > period / 2 ? 0 : after; // Else the second opens before the first shuts.
}

} // namespace viscera::circulation
