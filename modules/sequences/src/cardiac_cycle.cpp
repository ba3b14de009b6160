#include "viscera/sequences/cardiac_cycle.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "viscera/core/error.h"

namespace viscera::sequences {
namespace {

// The reference phases at which one part of the beat gives way to the next.
constexpr double kMitralCloses = 0.11;
constexpr double kAorticOpens = 0.17;
constexpr double kAorticCloses = 0.47;
constexpr double kMitralOpens = 0.54;
constexpr double kDiastasisBegins = 0.80;

// Systole at long and at short beats, s, and the beats (s) between which it changes.
constexpr double kLongSystole = 0.328;
constexpr double kShortSystole = 0.302;
constexpr double kLongBeat = 1.2;
constexpr double kShortBeat = 0.4;
/// Above about 150 beats a minute systole can have no more than this part of the beat.
constexpr double kLargestSystole = 0.76;
/// Isovolumic contraction as a part of systole: 40 of 330 ms.
constexpr double kContractionShare = 0.125;

// The parts of diastole when there is time enough, s; isovolumic relaxation after Copenhagen (96 +- 19 ms).
constexpr double kAtrialSeconds = 0.110;
constexpr double kRelaxationSeconds = 0.095;
constexpr double kFillingSeconds = 0.200;
/// However short the beat, diastasis keeps this part of diastole, so that the phase never jumps.
constexpr double kSmallestDiastasis = 0.08;

/// About x for small x and about 1 for large x, always below both.
double saturated(double x) {
  const double square = x * x;
  return x / std::pow(1 + square * square, 0.25);
}

Curve repeating(std::vector<Key> keys) {
  return Curve::periodic(std::move(keys), 1.0);
}

} // namespace

CardiacCycle::CardiacCycle(const CavityVolumes& endDiastole, const CavityVolumes& endSystole)
    : endDiastole_(endDiastole), endSystole_(endSystole),
      leftMl_(repeating({{0, 112.5},
                         {kMitralCloses, kEndDiastole.leftMl},
                         {kAorticOpens, kEndDiastole.leftMl},
                         {0.21, 120},
                         {0.27, 92},
                         {0.36, 65},
                         {0.43, 56},
                         {kAorticCloses, kEndSystole.leftMl},
                         {kMitralOpens, kEndSystole.leftMl},
                         {0.60, 76},
                         {0.66, 96},
                         {0.72, 105},
                         {kDiastasisBegins, 109}})),
      twist_(repeating({{0, 0},
                        {kMitralCloses, 0},
                        {kAorticOpens, -0.12},
                        {0.22, 0.05},
                        {0.45, 1},
                        {0.48, 0.97},
                        {0.55, 0.55},
                        {0.63, 0.12},
                        {0.72, 0}})),
      atrial_(repeating({{0, 0}, {0.07, 1}, {kMitralCloses, 0.92}, {0.20, 0.25}, {0.30, 0}})) {
  const auto empties = [](double full, double empty) {
    return empty > 0 && full > empty && std::isfinite(full);
  };
  if (!empties(endDiastole.leftMl, endSystole.leftMl) || !empties(endDiastole.rightMl, endSystole.rightMl))
    throw DataError("a ventricle has to hold less at the end of systole than at the end of diastole",
                    "cardiac cycle");
}

double CardiacCycle::emptying(double phase) const {
  return (kEndDiastole.leftMl - leftMl_.at(phase)) / (kEndDiastole.leftMl - kEndSystole.leftMl);
}

CavityVolumes CardiacCycle::volumes(double phase) const {
  const double empty = emptying(phase);
  return {endDiastole_.leftMl + empty * (endSystole_.leftMl - endDiastole_.leftMl),
          endDiastole_.rightMl + empty * (endSystole_.rightMl - endDiastole_.rightMl)};
}

double CardiacCycle::twist(double phase) const {
  return twist_.at(phase);
}

double CardiacCycle::atrialContraction(double phase) const {
  return atrial_.at(phase);
}

CardiacTimes CardiacCycle::times(double rateBpm) {
  const double beat = 60 / std::clamp(rateBpm, kLowestRateBpm, kHighestRateBpm);
  const double length = std::clamp((beat - kShortBeat) / (kLongBeat - kShortBeat), 0.0, 1.0);
  const double systole =
      std::min(kShortSystole + length * (kLongSystole - kShortSystole), kLargestSystole * beat);
  const double diastole = beat - systole;
  const double wanted = kAtrialSeconds + kRelaxationSeconds + kFillingSeconds;
  const double scale = saturated((1 - kSmallestDiastasis) * diastole / wanted);
  CardiacTimes times;
  times.isovolumicContraction = kContractionShare * systole;
  times.ejection = systole - times.isovolumicContraction;
  times.atrialSystole = scale * kAtrialSeconds;
  times.isovolumicRelaxation = scale * kRelaxationSeconds;
  times.rapidFilling = scale * kFillingSeconds;
  times.diastasis = diastole - scale * wanted;
  return times;
}

double CardiacCycle::referencePhase(double seconds, double rateBpm) const {
  const CardiacTimes t = times(rateBpm);
  std::vector<Key> keys{{0, 0}};
  const auto after = [&keys](double duration, double phase) {
    keys.push_back({keys.back().at + duration, phase});
  };
  after(t.atrialSystole, kMitralCloses);
  after(t.isovolumicContraction, kAorticOpens);
  after(t.ejection, kAorticCloses);
  after(t.isovolumicRelaxation, kMitralOpens);
  after(t.rapidFilling, kDiastasisBegins);
  return Curve::periodic(std::move(keys), t.cycle(), 1.0).at(seconds);
}

std::vector<Phase> CardiacCycle::phases(double rateBpm) {
  const CardiacTimes t = times(rateBpm);
  std::vector<Phase> phases;
  double begin = 0;
  const auto add = [&](const char* name, double duration) {
    const double end = begin + duration / t.cycle();
    phases.push_back({name, begin, end});
    begin = end;
  };
  add("atrial systole", t.atrialSystole);
  add("isovolumic contraction", t.isovolumicContraction);
  add("ejection", t.ejection);
  add("isovolumic relaxation", t.isovolumicRelaxation);
  add("filling", t.rapidFilling + t.diastasis);
  phases.back().end = 1;
  return phases;
}

} // namespace viscera::sequences
