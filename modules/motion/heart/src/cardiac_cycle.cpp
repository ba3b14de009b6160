#include "viscera/heart/cardiac_cycle.h"

#include <cmath>

#include "mix.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::heart {
namespace {

/// The part of a stroke that enters with the atria's contraction, the A wave.
constexpr double kAtrialKick = 0.24;
/// The part of the ejection in which it is rapid.
constexpr double kRapidEjection = 0.45;

/// How much of the stroke has left after that part of the ejection.
double ejected(double part) {
  static const sequences::Curve curve = sequences::Curve::through(
      {{0, 0}, {0.133, 0.139}, {0.333, 0.510}, {0.633, 0.868}, {0.867, 0.987}, {1, 1}});
  return curve.at(part);
}

/// How much of the E wave has entered after that part of it: it rises faster than it falls.
double entered(double part) {
  static const sequences::Curve curve =
      sequences::Curve::through({{0, 0}, {0.25, 0.33}, {0.5, 0.72}, {0.75, 0.92}, {1, 1}});
  return curve.at(part);
}

double clampedHeartRate(double rateBpm) {
  return std::clamp(rateBpm, CardiacCycle::kLowestRateBpm, CardiacCycle::kHighestRateBpm);
}

/// The twist begins against its direction, is largest just before the aortic valve shuts, and half undone
/// when the mitral valve opens.
sequences::Curve twistOf(const CardiacTimes& times, const VentricleClock& clock) {
  return sequences::Curve::periodic({{clock.inletShuts, 0},
                                     {clock.outletOpens, -0.12},
                                     {clock.outletOpens + 0.167 * times.ejection, 0.05},
                                     {clock.outletOpens + 0.933 * times.ejection, 1},
                                     {clock.outletShuts + 0.143 * times.isovolumicRelaxation, 0.97},
                                     {clock.inletOpens + 0.038 * times.earlyFilling, 0.55},
                                     {clock.inletOpens + 0.346 * times.earlyFilling, 0.12},
                                     {clock.inletOpens + 0.692 * times.earlyFilling, 0}},
                                    times.cycle);
}

sequences::Curve atrialOf(const CardiacTimes& times, const VentricleClock& clock) {
  return sequences::Curve::periodic({{0, 0},
                                     {0.64 * times.atrialSystole, 1},
                                     {times.atrialSystole, 0.92},
                                     {clock.outletOpens + 0.10 * times.ejection, 0.25},
                                     {clock.outletOpens + 0.43 * times.ejection, 0}},
                                    times.cycle);
}

} // namespace

CardiacBeat::CardiacBeat(double rateBpm, const CavityVolumes& endDiastole, const CavityVolumes& endSystole)
    : endDiastole_(endDiastole), endSystole_(endSystole), times_(cardiacTimes(rateBpm)),
      left_(leftClock(times_)), right_(rightClock(times_)),
      stroke_(heart::strokePart(times_, endDiastole.leftMl - endSystole.leftMl)),
      twist_(twistOf(times_, left_)), atrial_(atrialOf(times_, left_)) {}

double CardiacBeat::emptying(double t, const VentricleClock& clock) const {
  const auto early = [&](double since) {
    return (1 - kAtrialKick) * entered(std::min(1.0, since / times_.earlyFilling));
  };
  double filled = 0;
  if (t < clock.inletShuts)
    filled = early(t + times_.cycle - clock.inletOpens) +
             kAtrialKick * sequences::smoothStep(t / clock.inletShuts);
  else if (t < clock.outletOpens)
    filled = 1;
  else if (t < clock.outletShuts)
    filled = 1 - ejected((t - clock.outletOpens) / (clock.outletShuts - clock.outletOpens));
  else if (t >= clock.inletOpens)
    filled = early(t - clock.inletOpens);
  return 1 - stroke_ * filled;
}

CardiacInstant CardiacBeat::at(double seconds) const {
  const double t = seconds - std::floor(seconds / times_.cycle) * times_.cycle;
  CardiacInstant now;
  now.leftEmptying = emptying(t, left_);
  now.rightEmptying = emptying(t, right_);
  now.volumes = {mix(endDiastole_.leftMl, endSystole_.leftMl, now.leftEmptying),
                 mix(endDiastole_.rightMl, endSystole_.rightMl, now.rightEmptying)};
  now.twist = twist_.at(t);
  now.atrialContraction = atrial_.at(t);
  return now;
}

CardiacCycle::CardiacCycle(const CavityVolumes& endDiastole, const CavityVolumes& endSystole)
    : endDiastole_(endDiastole), endSystole_(endSystole) {
  const auto empties = [](double full, double empty) {
    return empty > 0 && full > empty && std::isfinite(full);
  };
  if (!empties(endDiastole.leftMl, endSystole.leftMl) || !empties(endDiastole.rightMl, endSystole.rightMl))
    throw DataError(misuse("a ventricle has to hold less at the end of systole than at the end of diastole"),
                    misuse("cardiac cycle"));
}

CardiacBeat CardiacCycle::beat(double rateBpm) const {
  return {clampedHeartRate(rateBpm), endDiastole_, endSystole_};
}

std::vector<sequences::Phase> CardiacCycle::phases(double rateBpm) {
  const CardiacTimes t = cardiacTimes(clampedHeartRate(rateBpm));
  const double alone = t.filling() - t.atrialSystole; // Until the atria contract.
  std::vector<sequences::Phase> phases;
  double seconds = 0;
  const auto add = [&](const char* name, double duration, const char* group = "diastole") {
    if (duration <= 0)
      return;
    phases.push_back({name, seconds / t.cycle, (seconds + duration) / t.cycle, group});
    seconds += duration;
  };
  add("atrial systole", t.atrialSystole);
  add("isovolumic contraction", t.isovolumicContraction, "systole");
  add("rapid ejection", kRapidEjection * t.ejection, "systole");
  add("reduced ejection", (1 - kRapidEjection) * t.ejection, "systole");
  add("isovolumic relaxation", t.isovolumicRelaxation);
  add("rapid filling", std::min(t.earlyFilling, alone));
  add("diastasis", t.diastasis());
  phases.back().end = 1;
  return phases;
}

} // namespace viscera::heart
