#include "viscera/circulation/indices.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "circuit.h"

namespace viscera::circulation {
namespace {

using Curve = std::vector<double>;

/// Forward flow, ml/s, from which a gradient is averaged.
constexpr double kFlows = 20;
/// The activations between which the relaxing ventricle's pressure is taken for an exponential.
constexpr double kRelaxing = 0.4;
constexpr double kRelaxed = 0.1;

double meanOf(const Curve& curve) {
  // The last sample is the first of the next beat.
  return std::accumulate(curve.begin(), curve.end() - 1, 0.0) / static_cast<double>(curve.size() - 1);
}

/// The largest value of sign * curve between samples: the vertex of the parabola through the largest and its
/// neighbours.
double extreme(const Curve& curve, double sign) {
  const std::size_t n = curve.size() - 1;
  std::size_t top = 0;
  for (std::size_t i = 0; i < n; ++i)
    if (sign * curve[i] > sign * curve[top])
      top = i;
  // y(s) = y_0 + slope s + bend s^2 / 2 through the three samples has its vertex at s = -slope / bend, where
  // y = y_0 - slope^2 / (2 bend).
  const double before = curve[(top + n - 1) % n];
  const double after = curve[(top + 1) % n];
  const double bend = before - 2 * curve[top] + after;
  const double slope = 0.5 * (after - before);
  return bend == 0 ? curve[top] : curve[top] - slope * slope / (2 * bend);
}

/// The value of `curve` where `along` is largest, likewise between samples.
double whereLargest(const Curve& along, const Curve& curve) {
  const std::size_t n = along.size() - 1;
  const auto top = static_cast<std::size_t>(std::max_element(along.begin(), along.end() - 1) - along.begin());
  const double before = along[(top + n - 1) % n], after = along[(top + 1) % n];
  const double bend = before - 2 * along[top] + after;
  const double place = bend == 0 ? 0 : 0.5 * (before - after) / bend; // From the sample, -1/2 to 1/2.
  const double next = curve[(top + (place > 0 ? 1 : n - 1)) % n];
  return curve[top] + std::abs(place) * (next - curve[top]);
}

double largest(const Curve& curve) {
  return extreme(curve, 1);
}

double smallest(const Curve& curve) {
  return extreme(curve, -1);
}

/// -int P dV = -int P V' dt around the loop, J, by Simpson's rule, h / 6 (f0 + 4 fm + f1) of each interval.
/// The middle is that of the cubic polynomials of time which the known rates make of both curves: the error
/// falls with h^4.
double loopArea(const Beat& beat, std::size_t chamber, const std::array<Curve, kChambers>& volumeRates) {
  const Curve& p = beat.pressure[chamber];
  const Curve& pRate = beat.pressureRate[chamber];
  const Curve& v = beat.volume[chamber];
  const Curve& vRate = volumeRates[chamber];
  const double h = beat.time[1] - beat.time[0];
  double sum = 0;
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    const double p0 = p[i], p1 = p[i + 1];
    // P_m = (P_0 + P_1) / 2 + h / 8 (P_0' - P_1'), V_m' = 3 (V_1 - V_0) / (2 h) - (V_0' + V_1') / 4.
    const double pMiddle = 0.5 * (p0 + p1) + h / 8 * (pRate[i] - pRate[i + 1]);
    const double vMiddleRate = 1.5 * (v[i + 1] - v[i]) / h - 0.25 * (vRate[i] + vRate[i + 1]);
    sum += h / 6 * (p0 * vRate[i] + 4 * pMiddle * vMiddleRate + p1 * vRate[i + 1]);
  }
  return -sum * kJoulePerMmHgMl;
}

/// How fast the chambers fill: what flows in less what flows out, ml/s.
std::array<Curve, kChambers> volumeRatesOf(const Parameters& p, const Beat& beat) {
  using enum Compartment;
  std::array<Curve, kChambers> rates;
  for (std::size_t i = 0; i < beat.time.size(); ++i) {
    const double toRight =
        (beat.pressureOf(systemicVeins)[i] - beat.pressureOf(ra)[i]) / p.systemic.veinResistance;
    const double toLeft =
        (beat.pressureOf(pulmonaryVeins)[i] - beat.pressureOf(la)[i]) / p.pulmonary.veinResistance;
    rates[at(lv)].push_back(beat.flowOf(Valve::mitral)[i] - beat.flowOf(Valve::aortic)[i]);
    rates[at(rv)].push_back(beat.flowOf(Valve::tricuspid)[i] - beat.flowOf(Valve::pulmonic)[i]);
    rates[at(la)].push_back(toLeft - beat.flowOf(Valve::mitral)[i]);
    rates[at(ra)].push_back(toRight - beat.flowOf(Valve::tricuspid)[i]);
  }
  return rates;
}

ChamberIndices chamberIndices(const Beat& beat, std::size_t chamber,
                              const std::array<Curve, kChambers>& volumeRates) {
  const Curve& volume = beat.volume[chamber];
  const Curve& pressure = beat.pressure[chamber];
  ChamberIndices indices;
  indices.edvMl = largest(volume);
  indices.esvMl = smallest(volume);
  indices.svMl = indices.edvMl - indices.esvMl;
  indices.ef = indices.svMl / indices.edvMl;
  const bool atrium = chamber >= at(Compartment::la);
  indices.edpMmHg = atrium ? whereLargest(volume, pressure) : pressure.front();
  indices.meanMmHg = meanOf(pressure);
  indices.highestMmHg = largest(pressure);
  indices.dpdtMax = largest(beat.pressureRate[chamber]);
  indices.strokeWorkJ = loopArea(beat, chamber, volumeRates);
  indices.strokeWorkByEnergyJ = beat.work[chamber];
  return indices;
}

ArteryIndices arteryIndices(const Curve& pressure) {
  return {largest(pressure), smallest(pressure), meanOf(pressure)};
}

/// The longest time in which the valve is shut begins and ends with what its name says; a valve may also
/// close for a moment in the middle of filling.
std::optional<ValveTimes> valveTimes(const Beat& beat, Valve valve) {
  const std::vector<ValveTimes> all = openTimes(beat, valve);
  std::optional<ValveTimes> found;
  double longest = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double opens = all[i].opens, shuts = all[(i + all.size() - 1) % all.size()].shuts;
    const double length = opens - shuts + (shuts < opens ? 0 : beat.period);
    if (length > longest)
      found = ValveTimes{opens, shuts};
    longest = std::max(longest, length);
  }
  return found;
}

/// Mean and peak of upstream less downstream pressure while blood flows forward.
std::pair<double, double> gradients(const Curve& flow, const Curve& from, const Curve& to) {
  double sum = 0, peak = 0;
  int count = 0;
  for (std::size_t i = 0; i + 1 < flow.size(); ++i)
    if (flow[i] > kFlows) {
      sum += from[i] - to[i];
      peak = std::max(peak, from[i] - to[i]);
      ++count;
    }
  return {count > 0 ? sum / count : 0, peak};
}

/// The volume that flows backward through a valve over a beat, ml.
double backward(const Beat& beat, Valve valve) {
  double sum = 0;
  // -int min(0, Q) dt by even samples of one period, where the trapezium rule is a plain sum.
  for (std::size_t i = 0; i + 1 < beat.time.size(); ++i)
    sum -= std::min(0.0, beat.flowOf(valve)[i]);
  return sum * (beat.time[1] - beat.time[0]);
}

/// The value of `curve` where `along`, falling from its peak, passes `level`; linear between samples.
double whereFalls(const Curve& along, double level, const Curve& curve) {
  const auto peak = static_cast<std::size_t>(std::max_element(along.begin(), along.end()) - along.begin());
  for (std::size_t i = peak + 1; i < along.size(); ++i)
    if (along[i] <= level) {
      const double part = (along[i - 1] - level) / (along[i - 1] - along[i]);
      return curve[i - 1] + part * (curve[i] - curve[i - 1]);
    }
  return curve.back();
}

/// The time constant of the left ventricle's pressure while it relaxes, above whatever it falls to: pressure
/// against its rate at two instants.
double relaxation(const Beat& beat) {
  // P = P_end + c exp(-t / tau) makes dP/dt = -(P - P_end) / tau: between two instants P_end drops out, and
  // tau = (P_1 - P_2) / (dP/dt_2 - dP/dt_1).
  const Curve& e = beat.activation[at(Compartment::lv)];
  const Curve& p = beat.pressureOf(Compartment::lv);
  const Curve& rate = beat.pressureRate[at(Compartment::lv)];
  const double fall = whereFalls(e, kRelaxing, p) - whereFalls(e, kRelaxed, p);
  const double slowing = whereFalls(e, kRelaxed, rate) - whereFalls(e, kRelaxing, rate);
  return slowing > 0 ? fall / slowing : 0;
}

/// A curve at an instant of the beat; linear between samples.
double between(const Beat& beat, const Curve& curve, double seconds) {
  const double place = seconds / (beat.time[1] - beat.time[0]);
  const auto before = static_cast<std::size_t>(place);
  return curve[before] + (place - std::floor(place)) * (curve[before + 1] - curve[before]);
}

/// The times of the left heart between its two valves.
void addTimes(Indices& indices, double period) {
  const auto& mitral = indices.valves[at(Valve::mitral)];
  const auto& aortic = indices.valves[at(Valve::aortic)];
  if (aortic)
    indices.ejectionSeconds = openSeconds(*aortic, period);
  if (!mitral || !aortic)
    return;
  indices.isovolumicContractionSeconds = bothShutSeconds(*mitral, *aortic, period);
  indices.isovolumicRelaxationSeconds = bothShutSeconds(*aortic, *mitral, period);
}

} // namespace

double endSystolicPressure(const Chamber& chamber, double volumeMl) {
  return chamber.ees * (volumeMl - chamber.v0);
}

double relaxedPressure(const Chamber& chamber, double volumeMl) {
  return chamber.a * std::expm1(chamber.b * (volumeMl - chamber.v0));
}

Indices indicesOf(const Parameters& parameters, const Beat& beat) {
  using enum Compartment;
  Indices indices;
  const auto volumeRates = volumeRatesOf(parameters, beat);
  for (std::size_t i = 0; i < kChambers; ++i)
    indices.chambers[i] = chamberIndices(beat, i, volumeRates);
  indices.aorta = arteryIndices(beat.pressureOf(systemicArteries));
  indices.pulmonaryArtery = arteryIndices(beat.pressureOf(pulmonaryArteries));
  // SV = int Q_aortic dt, what leaks back taken off, and CO = SV HR.
  indices.forwardStrokeMl = meanOf(beat.flowOf(Valve::aortic)) * beat.period;
  indices.cardiacOutputLMin = indices.forwardStrokeMl * parameters.rate / 1000;
  indices.mitralRegurgitationMl = backward(beat, Valve::mitral);
  indices.aorticRegurgitationMl = backward(beat, Valve::aortic);
  const ChamberIndices& left = indices.of(lv);
  indices.mitralRegurgitantFraction = left.svMl > 0 ? indices.mitralRegurgitationMl / left.svMl : 0;
  std::tie(indices.aorticMeanGradient, indices.aorticPeakGradient) =
      gradients(beat.flowOf(Valve::aortic), beat.pressureOf(lv), beat.pressureOf(systemicArteries));
  indices.mitralMeanGradient =
      gradients(beat.flowOf(Valve::mitral), beat.pressureOf(la), beat.pressureOf(lv)).first;
  for (std::size_t i = 0; i < kValves; ++i)
    indices.valves[i] = valveTimes(beat, static_cast<Valve>(i));
  addTimes(indices, beat.period);
  indices.relaxationSeconds = relaxation(beat);
  // Ea = P_es / SV, with P_es where the activation is largest; Ea / Ees is the coupling.
  indices.arterialElastance =
      between(beat, beat.pressureOf(lv), endSystoleSeconds(parameters.rate)) / left.svMl;
  indices.couplingRatio = indices.arterialElastance / parameters.lv.ees;
  return indices;
}

} // namespace viscera::circulation
