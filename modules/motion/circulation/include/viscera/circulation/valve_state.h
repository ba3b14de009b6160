#pragma once

#include <vector>

#include "viscera/circulation/beat.h"

/// The one definition of an open and of a shut valve. Phases, heart sounds, the numbers of a beat, the bars
/// of Wiggers's diagram and the leaflets that are drawn all use it.
namespace viscera::circulation {

/// A valve is shut while its opening (0 to 1) is no larger than this: its leaflets touch.
inline constexpr double kTouching = 0.02;

constexpr bool isOpen(double opening) {
  return opening > kTouching;
}

/// How far leaflets are apart, 0 to 1: 0 exactly while the valve is shut.
constexpr double apart(double opening) {
  return isOpen(opening) ? (opening - kTouching) / (1 - kTouching) : 0;
}

/// When a valve opens and shuts, s from the beginning of the ventricles' contraction, 0 to a period. A valve
/// that is open across the end of the beat shuts at an earlier time than it opens.
struct ValveTimes {
  double opens = 0;
  double shuts = 0;
};

/// How long a valve is open between these times, s.
double openSeconds(const ValveTimes& times, double period);

/// Every time in which a valve is open, in the order of opening; empty for a valve that never opens or never
/// shuts. Times are interpolated linearly between samples. O(samples).
std::vector<ValveTimes> openTimes(const Beat& beat, Valve valve);

/// Time from the instant at which the first shuts to that at which the second opens, s; over the end of the
/// beat where that is nearer, and 0 where the second opens before the first shuts.
double bothShutSeconds(const ValveTimes& first, const ValveTimes& second, double period);

} // namespace viscera::circulation
