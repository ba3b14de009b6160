#include "viscera/heart/cardiac_cycle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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
  return sequences::Curve::periodic({{kBeforeAtria, 0},
                                     {kBeforeAtria + 0.64 * times.atrialSystole, 1},
                                     {kBeforeAtria + times.atrialSystole, 0.92},
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

/// `t` from the contraction of the atria to that of the next beat.
double CardiacBeat::emptying(double t, const VentricleClock& ofBeat) const {
  const VentricleClock clock{ofBeat.inletShuts - kBeforeAtria, ofBeat.outletOpens - kBeforeAtria,
                             ofBeat.outletShuts - kBeforeAtria, ofBeat.inletOpens - kBeforeAtria};
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
  const auto inBeat = [&](double s) { return s - std::floor(s / times_.cycle) * times_.cycle; };
  const double t = inBeat(seconds);
  CardiacInstant now;
  now.leftEmptying = emptying(inBeat(seconds - kBeforeAtria), left_);
  now.rightEmptying = emptying(inBeat(seconds - kBeforeAtria), right_);
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

std::vector<sequences::Phase> phasesOf(const LeftHeartEvents& events) {
  struct Part {
    const char* name;
    const char* group;
    double begin; ///< Fraction of the cycle.
  };
  const VentricleClock& valves = events.valves;
  const double ejection = valves.outletShuts - valves.outletOpens;
  const double nextAtria = events.atriaContract + events.cycle;
  const double filled = std::min(valves.inletOpens + events.earlyFilling, nextAtria);
  // Each part ends where the next one begins.
  const std::array<std::pair<Part, double>, 7> all = {
      {{{"atrial systole", "diastole", events.atriaContract}, valves.inletShuts},
       {{"isovolumic contraction", "systole", valves.inletShuts}, valves.outletOpens},
       {{"rapid ejection", "systole", valves.outletOpens}, valves.outletOpens + kRapidEjection * ejection},
       {{"reduced ejection", "systole", valves.outletOpens + kRapidEjection * ejection}, valves.outletShuts},
       {{"isovolumic relaxation", "diastole", valves.outletShuts}, valves.inletOpens},
       {{"rapid filling", "diastole", valves.inletOpens}, filled},
       {{"diastasis", "diastole", filled}, nextAtria}}};
  constexpr double kLeast = 1e-9; // Of a part, s.
  std::vector<Part> parts;
  for (const auto& [part, end] : all)
    if (end - part.begin > kLeast) {
      const double begin = part.begin / events.cycle;
      parts.push_back({part.name, part.group, begin - std::floor(begin)});
    }
  std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.begin < b.begin; });
  std::vector<sequences::Phase> phases;
  if (parts.front().begin > 0)
    phases.push_back({parts.back().name, 0, parts.front().begin, parts.back().group});
  for (std::size_t i = 0; i < parts.size(); ++i)
    phases.push_back(
        {parts[i].name, parts[i].begin, i + 1 < parts.size() ? parts[i + 1].begin : 1.0, parts[i].group});
  return phases;
}

std::vector<sequences::Phase> CardiacCycle::phases(double rateBpm) {
  const CardiacTimes times = cardiacTimes(clampedHeartRate(rateBpm));
  return phasesOf({times.cycle, kBeforeAtria, leftClock(times), times.earlyFilling});
}

} // namespace viscera::heart
