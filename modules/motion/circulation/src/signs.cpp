#include "viscera/circulation/signs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "circuit.h"

namespace viscera::circulation {
namespace {

/// One wave of the electrocardiogram.
struct Wave {
  double center; ///< s
  double height; ///< mV
  double width;  ///< s
};

/// Electricity comes before the pressure that it raises: from the top of R to the beginning of contraction,
/// s.
constexpr double kRLead = 0.03;
constexpr double kPLead = 0.01;
/// The top of T, as a part of the time to the end of systole.
constexpr double kTPart = 0.8;

/// Reference values at rest for the loudness of sounds.
constexpr double kRestDpdt = 1600;    ///< mmHg/s
constexpr double kRestDiastolic = 80; ///< mmHg
constexpr double kPulmonicPart =
    0.25; ///< The pulmonary valve's sound beside the aortic one's at like pressure.
/// Stiffness times inflow, mmHg/s, from which rapid filling and the atrium's contraction are heard, and what
/// adds 1 to their loudness. At rest they are about 37 and 59.
constexpr double kQuietEarly = 60;
constexpr double kQuietLate = 80;
constexpr double kLoudFilling = 150;
/// Murmurs, m/s: the slowest jet that is heard, and what makes it as loud as the first sound.
constexpr double kQuietJet = 2;
constexpr double kLoudJet = 6;

std::array<Wave, 5> wavesOf(const Parameters& p) {
  const double systole = endSystoleSeconds(p.rate);
  const double conduction = conductionSeconds(p);
  return {{{-conduction - kPLead, 0.15, 0.022},
           {-kRLead - 0.025, -0.12, 0.008},
           {-kRLead, 1.1, 0.010},
           {-kRLead + 0.025, -0.25, 0.009},
           {kTPart * systole - kRLead, 0.3, 0.11 * systole}}};
}

/// `seconds` to the nearest repetition of `center`.
double distance(double seconds, double center, double period) {
  return std::remainder(seconds - center, period);
}

double heard(double rise, double quiet) {
  return std::clamp((rise - quiet) / kLoudFilling, 0.0, 1.0);
}

/// The largest product of the relaxed left ventricle's stiffness and what flows into it between two instants,
/// mmHg/s, and when.
std::pair<double, double> stiffestFilling(const Chamber& lv, const Beat& beat, double from, double to) {
  double best = 0, when = from;
  for (std::size_t i = 0; i + 1 < beat.time.size(); ++i) {
    if (beat.time[i] < from || beat.time[i] >= to)
      continue;
    // dP/dt = (dP/dV) Q, with dP/dV = a b exp(b (V - V0)) = b (P + a) of the relaxed P = a
    // (exp(b (V - V0)) - 1).
    const double stiffness = lv.b * (relaxedPressure(lv, beat.volumeOf(Compartment::lv)[i]) + lv.a);
    const double rise = stiffness * beat.flowOf(Valve::mitral)[i];
    if (rise > best) {
      best = rise;
      when = beat.time[i];
    }
  }
  return {best, when};
}

/// Speed of the blood in the narrowest part of a valve, m/s.
double jet(const ValveAreas& areas, double flow, double open) {
  // v = |Q| / A in cm/s; what seeps through a shut valve is no jet.
  const double area = openArea(areas, open);
  return area > 10 * kShutArea ? std::abs(flow) / area / 100 : 0;
}

/// A noise that is the same each time: tones that have no common period.
double noise(double seconds) {
  constexpr std::array<double, 5> kTones = {97, 131, 173, 211, 263};
  double sum = 0;
  for (std::size_t i = 0; i < kTones.size(); ++i)
    sum += std::sin(2 * std::numbers::pi * kTones[i] * seconds + 1.7 * static_cast<double>(i));
  return sum / kTones.size();
}

} // namespace

double electrocardiogram(const Parameters& parameters, double seconds) {
  // sum_i h_i exp(-(t - c_i)^2 / (2 w_i^2)), each to the nearest repetition of its wave.
  double sum = 0;
  for (const Wave& wave : wavesOf(parameters)) {
    const double x = distance(seconds, wave.center, 60 / parameters.rate) / wave.width;
    sum += wave.height * std::exp(-0.5 * x * x);
  }
  return sum;
}

Excitation excitationOf(const Parameters& parameters) {
  constexpr double kWidths = 2.25; // A wave is seen so many widths from its top.
  const std::array<Wave, 5> waves = wavesOf(parameters);
  const Wave &p = waves[0], &q = waves[1], &s = waves[3];
  return {p.center - kWidths * p.width, p.center + kWidths * p.width, q.center - kWidths * q.width,
          s.center + kWidths * s.width};
}

double excitationMs(const Parameters& parameters, double seconds) {
  constexpr double kMsPerS = 1000;
  constexpr double kMostAtria = 0.8; // The part of the time to Q: in a fast heart P reaches into QRS.
  const Excitation at = excitationOf(parameters);
  const double period = 60 / parameters.rate;
  const double turns = std::floor((seconds - at.sinusNode) / period);
  const double since = seconds - at.sinusNode - turns * period;
  const std::array<std::pair<double, double>, 4> marks = {
      {{0, 0},
       {std::min(at.atriaDone - at.sinusNode, kMostAtria * (at.ventriclesBegin - at.sinusNode)),
        kAtriaDoneMs},
       {at.ventriclesBegin - at.sinusNode, kVentriclesBeginMs},
       {at.ventriclesDone - at.sinusNode, kVentriclesDoneMs}}};
  for (std::size_t i = 1; i < marks.size(); ++i) {
    const auto& [from, fromMs] = marks[i - 1];
    const auto& [to, toMs] = marks[i];
    if (since < to)
      return fromMs + (toMs - fromMs) * (since - from) / (to - from);
  }
  return kVentriclesDoneMs + kMsPerS * (since - marks.back().first);
}

std::vector<HeartSound> heartSounds(const Parameters& parameters, const Beat& beat, const Indices& indices) {
  std::vector<HeartSound> sounds;
  const auto shuts = [&](Valve valve, const char* name, double loudness, double frequency, double fading) {
    if (const auto& times = indices.valves[at(valve)])
      sounds.push_back({name, times->shuts, std::min(loudness, 2.0), frequency, fading});
  };
  shuts(Valve::mitral, "S1 mitral", indices.of(Compartment::lv).dpdtMax / kRestDpdt, 45, 0.025);
  shuts(Valve::tricuspid, "S1 tricuspid", 0.4 * indices.of(Compartment::rv).dpdtMax / 300, 50, 0.02);
  shuts(Valve::aortic, "S2 aortic", 0.8 * indices.aorta.diastolic / kRestDiastolic, 65, 0.015);
  shuts(Valve::pulmonic, "S2 pulmonic", kPulmonicPart * indices.pulmonaryArtery.diastolic / 10, 60, 0.015);
  const auto& mitral = indices.valves[at(Valve::mitral)];
  if (!mitral)
    return sounds;
  const double atrialStart = beat.period - conductionSeconds(parameters);
  const auto [early, earlyTime] = stiffestFilling(parameters.lv, beat, mitral->opens, atrialStart);
  const auto [late, lateTime] = stiffestFilling(parameters.lv, beat, atrialStart, beat.period);
  if (const double loudness = heard(early, kQuietEarly); loudness > 0)
    sounds.push_back({"S3", earlyTime, loudness, 30, 0.025});
  if (const double loudness = heard(late, kQuietLate); loudness > 0)
    sounds.push_back({"S4", lateTime, loudness, 28, 0.025});
  return sounds;
}

std::vector<double> phonocardiogram(const Parameters& parameters, const Beat& beat, const Indices& indices) {
  const std::vector<HeartSound> sounds = heartSounds(parameters, beat, indices);
  const std::array<ValveAreas, kValves> areas = {parameters.mitral, parameters.aortic, parameters.tricuspid,
                                                 parameters.pulmonic};
  std::vector<double> curve;
  for (std::size_t i = 0; i < beat.time.size(); ++i) {
    const double now = beat.time[i];
    double sum = 0;
    for (const HeartSound& sound : sounds) {
      // L exp(-t / tau) sin(2 pi f t) from the beginning of the sound, also where that was in the beat
      // before.
      const double since = now - sound.seconds + (now < sound.seconds ? beat.period : 0);
      sum += sound.loudness * std::exp(-since / sound.fading) *
             std::sin(2 * std::numbers::pi * sound.frequency * since);
    }
    for (std::size_t v = 0; v < kValves; ++v) {
      const double speed = jet(areas[v], beat.flow[v][i], beat.open[v][i]);
      sum += std::clamp((speed - kQuietJet) / (kLoudJet - kQuietJet), 0.0, 1.0) * noise(now);
    }
    curve.push_back(sum);
  }
  return curve;
}

} // namespace viscera::circulation
