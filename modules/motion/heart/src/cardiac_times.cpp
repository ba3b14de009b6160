#include "viscera/heart/cardiac_times.h"

#include <cmath>

namespace viscera::heart {
namespace {

constexpr double kMs = 1e-3;
constexpr double kShortestEjection = 130; ///< ms

/// The rate at which the Copenhagen study measured people at rest, a minute.
constexpr double kCopenhagenBpm = 65;

/// The rate at which the waves of filling are given.
constexpr double kWavesBpm = 75;
constexpr double kEarlyMs = 200;
constexpr double kAtrialMs = 110;
/// The factor of a wave's duration when the rate doubles.
constexpr double kEarlyAtDouble = 0.82;
constexpr double kAtrialAtDouble = 0.84;
/// The atria contract within this part of the filling, however short that is.
constexpr double kLongestAtrialPart = 0.8;

double ejectionMs(double rate) {
  return std::max({413 - 1.7 * rate, 371 - 1.2 * rate, kShortestEjection});
}

double contractionMs(double rate) {
  return std::clamp(40 - 0.4 * (rate - kCopenhagenBpm), 25.0, 40.0);
}

double relaxationMs(double rate) {
  constexpr double kLeft = 0.46, kRise = 0.85;
  return std::clamp(96 * std::pow(kLeft, (rate / kCopenhagenBpm - 1) / kRise), 25.0, 110.0);
}

double waveMs(double standard, double atDouble, double rate) {
  // A wave keeps the part `atDouble` of itself with every doubling of the rate.
  return standard * std::pow(atDouble, std::log2(rate / kWavesBpm));
}

// Parts of the left ventricle's isovolumic contraction: when the right ventricle's valves move.
constexpr double kTricuspidShuts = 0.25;
constexpr double kPulmonaryOpens = 0.65;
// Parts of its isovolumic relaxation.
constexpr double kPulmonaryShuts = 0.18;
constexpr double kTricuspidOpens = 0.60;

} // namespace

CardiacTimes cardiacTimes(double rateBpm) {
  CardiacTimes times;
  times.cycle = 60 / rateBpm;
  times.isovolumicContraction = kMs * contractionMs(rateBpm);
  times.ejection = kMs * ejectionMs(rateBpm);
  times.isovolumicRelaxation = kMs * relaxationMs(rateBpm);
  times.earlyFilling = std::min(kMs * waveMs(kEarlyMs, kEarlyAtDouble, rateBpm), times.filling());
  times.atrialSystole =
      std::min(kMs * waveMs(kAtrialMs, kAtrialAtDouble, rateBpm), kLongestAtrialPart * times.filling());
  return times;
}

double strokePart(const CardiacTimes& times, double strokeMl) {
  return std::min(1.0, kFastestFilling * times.diastole() / strokeMl);
}

VentricleClock leftClock(const CardiacTimes& times) {
  VentricleClock clock;
  clock.inletShuts = kBeforeAtria + times.atrialSystole;
  clock.outletOpens = clock.inletShuts + times.isovolumicContraction;
  clock.outletShuts = clock.outletOpens + times.ejection;
  clock.inletOpens = clock.outletShuts + times.isovolumicRelaxation;
  return clock;
}

VentricleClock rightClock(const CardiacTimes& times) {
  const VentricleClock left = leftClock(times);
  VentricleClock clock;
  clock.inletShuts = left.inletShuts + kTricuspidShuts * times.isovolumicContraction;
  clock.outletOpens = left.inletShuts + kPulmonaryOpens * times.isovolumicContraction;
  clock.outletShuts = left.outletShuts + kPulmonaryShuts * times.isovolumicRelaxation;
  clock.inletOpens = left.outletShuts + kTricuspidOpens * times.isovolumicRelaxation;
  return clock;
}

} // namespace viscera::heart
