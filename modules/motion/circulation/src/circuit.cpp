#include "circuit.h"

#include <algorithm>
#include <numbers>

namespace viscera::circulation {
namespace {

/// How much faster contraction begins than it ends; fitted to the largest dP/dt.
constexpr double kSkew = 0.75;
constexpr double kQuarterTurn = std::numbers::pi / 2;
/// Seconds from the beginning of an atrium's contraction to its height.
constexpr double kAtrialPeak = 0.125;
/// The peak lasts no longer than this part of the beat at fast rates.
constexpr double kAtrialPeakShare = 0.15;
/// How fast leaflets follow the pressure across them, 1/(mmHg s): the opening changes by so much of what is
/// left, as in Mynard and others 2012, doi 10.1002/cnm.1466; fitted to the 20 to 40 ms that leaflets need.
constexpr double kLeafletPace = 15;
/// Unlike there, leaflets are no faster than this, 1/s: what holds them back is their own mass.
constexpr double kLeafletLimit = 500;
/// Where the jet behind an arterial valve has spread and its speed has turned back into pressure, cm^2:
/// ascending aorta and pulmonary trunk, 28 and 26 mm wide.
constexpr double kAorta = 6.2;
constexpr double kPulmonaryTrunk = 5.3;
/// Blood that is accelerated with a valve's, cm.
constexpr double kArterialLength = 1.0;
constexpr double kAtrialLength = 2.0;
/// Pressure of a pericardium that heart and fluid just fill, mmHg.
constexpr double kPericardialUnit = 1.0;

double wrapped(double seconds, double period) {
  const double rest = std::fmod(seconds, period);
  return rest < 0 ? rest + period : rest;
}

/// What the square of the flow costs, 1/cm^4. Behind an arterial valve a part of the speed turns back into
/// pressure, which leaves (1 / A - 1 / A_artery)^2 of 1 / A^2 (Garcia and others 2000, doi
/// 10.1161/01.CIR.101.7.765).
double lossOf(double artery, double area, double flow) {
  const double spread = flow > 0 && artery > area ? 1 / artery : 0;
  return (1 / area - spread) * (1 / area - spread);
}

/// 1/s; of the gradient's sign.
double leafletPace(double gradient) {
  const double wanted = kLeafletPace * gradient;
  return wanted / (1 + std::abs(wanted) / kLeafletLimit);
}

} // namespace

Circuit::Circuit(const Parameters& p, int steps)
    : period_(60 / p.rate), steps_(steps), systemic_(p.systemic), pulmonary_(p.pulmonary),
      fluid_(p.pericardialFluid), room_(p.pericardialRoom), scale_(p.pericardialScale) {
  const double ventricular = endSystoleSeconds(p.rate);
  const double atrial = std::min(kAtrialPeak, kAtrialPeakShare * period_);
  const double conduction = conductionSeconds(p);
  // After the slopes have met at 1/2 a beat leaves 1/2 exp(-f / tau), f the time since then. With all the
  // beats before, T apart, that is 1/2 sum_k exp(-k T / tau) = 1/2 / (1 - exp(-T / tau)) at f = 0.
  const auto pump = [this](const Chamber& chamber, double start, double endSystole) {
    return Pump{chamber, start, endSystole, 0.5 / (1 - std::exp(-period_ / chamber.tau))};
  };
  pumps_ = {pump(p.lv, 0, ventricular), pump(p.rv, 0, ventricular), pump(p.la, -conduction, atrial),
            pump(p.ra, -conduction, atrial)};
  using enum Compartment;
  gates_ = {Gate{p.mitral, at(la), at(lv), kAtrialLength, 0, 0},
            Gate{p.aortic, at(lv), at(systemicArteries), kArterialLength, p.systemic.impedance, kAorta},
            Gate{p.tricuspid, at(ra), at(rv), kAtrialLength, 0, 0},
            Gate{p.pulmonic, at(rv), at(pulmonaryArteries), kArterialLength, p.pulmonary.impedance,
                 kPulmonaryTrunk}};
  activations_.resize(static_cast<std::size_t>(2 * steps) + 1);
  for (std::size_t half = 0; half < activations_.size(); ++half)
    for (std::size_t i = 0; i < kChambers; ++i)
      activations_[half][i] = activation(pumps_[i], period_ * static_cast<double>(half) / (2 * steps)).value;
}

/// Rises as a raised cosine; falls as a shorter one until half is left, then as an exponential of the same
/// slope. What earlier beats have left goes on fading below it, which makes the curve continuous and periodic
/// at every rate.
Circuit::Activation Circuit::activation(const Pump& pump, double seconds) const {
  // Let f = t - t_es - (pi / 2) tau: this beat's own part 1/2 exp(-f / tau) goes on at f = 0 from
  // (1 + cos((t - t_es) / tau)) / 2 with the same value, 1/2, and the same slope, -1 / (2 tau); half counts
  // the earlier beats as well.
  const double since = wrapped(seconds - pump.start, period_);
  const double tau = pump.chamber.tau;
  const double past = since - pump.endSystole;
  const double fading = past - kQuarterTurn * tau;
  if (fading >= 0) {
    const double value = pump.half * std::exp(-fading / tau);
    return {value, -value / tau};
  }
  // The earlier beats alone: half less this beat's own 1/2.
  const double left = (pump.half - 0.5) * std::exp(-fading / tau);
  if (past >= 0)
    return {0.5 * (1 + std::cos(past / tau)) + left, -(0.5 * std::sin(past / tau) + left) / tau};
  // e = (1 - cos(pi x (1 + k (1 - x)))) / 2, x = t / t_es: still from 0 to 1 with level ends but for what is
  // left, and faster at first for k > 0.
  const double part = since / pump.endSystole;
  const double turn = std::numbers::pi * part * (1 + kSkew * (1 - part));
  const double pace = std::numbers::pi * (1 + kSkew * (1 - 2 * part)) / pump.endSystole;
  return {0.5 * (1 - std::cos(turn)) + left, 0.5 * pace * std::sin(turn) - left / tau};
}

Instant Circuit::instant(const State& state, double seconds) const {
  // The four chambers share the pericardium's P_0 exp((sum V_i + fluid - room) / scale), on which each adds
  // (1 - e) a (exp(b (V - V0)) - 1) + e Ees (V - V0): relaxed and contracted muscle, mixed by the activation
  // e.
  Instant now;
  double heart = fluid_ - room_;
  for (std::size_t i = 0; i < kChambers; ++i)
    heart += state[i];
  now.activation = activations_[static_cast<std::size_t>(std::lround(2 * steps_ * seconds / period_))];
  now.pericardium = kPericardialUnit * std::exp(heart / scale_);
  for (std::size_t i = 0; i < kChambers; ++i) {
    const Chamber& c = pumps_[i].chamber;
    const double e = now.activation[i];
    const double stretch = state[i] - c.v0;
    now.pressure[i] = now.pericardium + (1 - e) * c.a * (std::exp(c.b * stretch) - 1) + e * c.ees * stretch;
  }
  using enum Compartment;
  // P = V / C, and Q = (P_from - P_to) / R between neighbours.
  const auto vessel = [&](Compartment c, double compliance) {
    return now.pressure[at(c)] = state[at(c)] / compliance;
  };
  const double arteries = vessel(systemicArteries, systemic_.arteryCompliance);
  const double veins = vessel(systemicVeins, systemic_.veinCompliance);
  const double lungArteries = vessel(pulmonaryArteries, pulmonary_.arteryCompliance);
  const double lungVeins = vessel(pulmonaryVeins, pulmonary_.veinCompliance);
  now.systemicFlow = (arteries - veins) / systemic_.resistance;
  now.pulmonaryFlow = (lungArteries - lungVeins) / pulmonary_.resistance;
  now.systemicReturn = (veins - now.pressure[at(ra)]) / systemic_.veinResistance;
  now.pulmonaryReturn = (lungVeins - now.pressure[at(la)]) / pulmonary_.veinResistance;
  // The root of an artery has P = V / C + Z Q, Z its characteristic impedance.
  for (std::size_t i = 0; i < kValves; ++i) {
    const Gate& gate = gates_[i];
    now.pressure[gate.to] += gate.impedance * state[kCompartments + i];
    now.gradient[i] = now.pressure[gate.from] - now.pressure[gate.to];
  }
  return now;
}

void Circuit::rates(const State& state, const Instant& now, State& rates) const {
  using enum Compartment;
  // dV/dt = Q_in - Q_out: what one loses the other gets, so that the sum of the volumes stays.
  for (std::size_t i = 0; i < kCompartments; ++i)
    rates[i] = 0;
  const auto move = [&rates](std::size_t from, std::size_t to, double flow) {
    rates[from] -= flow;
    rates[to] += flow;
  };
  move(at(systemicArteries), at(systemicVeins), now.systemicFlow);
  move(at(systemicVeins), at(ra), now.systemicReturn);
  move(at(pulmonaryArteries), at(pulmonaryVeins), now.pulmonaryFlow);
  move(at(pulmonaryVeins), at(la), now.pulmonaryReturn);
  for (std::size_t i = 0; i < kValves; ++i) {
    const Gate& gate = gates_[i];
    const double flow = state[kCompartments + i];
    const double opening = state[kCompartments + kValves + i];
    move(gate.from, gate.to, flow);
    // L dQ/dt = gradient - B Q|Q|, with B = rho / 2 times the loss and L = rho l / A.
    const double area = openArea(gate.areas, opening);
    rates[kCompartments + i] =
        now.gradient[i] * kDynPerMmHg * area / (kBloodDensity * gate.length) -
        flow * std::abs(flow) * area * lossOf(gate.artery, area, flow) / (2 * gate.length);
    // dz/dt = k (1 - z) for a gradient that opens, k z with k < 0 for one that shuts: z stays within 0 and 1.
    rates[kCompartments + kValves + i] =
        leafletPace(now.gradient[i]) * (now.gradient[i] > 0 ? 1 - opening : opening);
  }
}

std::array<double, kChambers + 1> Circuit::powers(const State& state, const Instant& now,
                                                  const State& rates) const {
  // dW/dt = -P dV/dt of each chamber; lost is sum (P_from - P_to) Q over every connection, of elastic
  // pressures alone: Z belongs to the loss, and is added to the gradient that it was taken from. Over a
  // periodic beat the elastic vessels give back what they took, so that sum W = int lost.
  std::array<double, kChambers + 1> powers{};
  for (std::size_t i = 0; i < kChambers; ++i)
    powers[i] = -now.pressure[i] * rates[i];
  double& lost = powers[kChambers];
  for (std::size_t i = 0; i < kValves; ++i) {
    const double flow = state[kCompartments + i];
    lost += (now.gradient[i] + gates_[i].impedance * flow) * flow;
  }
  lost += systemic_.resistance * now.systemicFlow * now.systemicFlow +
          systemic_.veinResistance * now.systemicReturn * now.systemicReturn +
          pulmonary_.resistance * now.pulmonaryFlow * now.pulmonaryFlow +
          pulmonary_.veinResistance * now.pulmonaryReturn * now.pulmonaryReturn;
  return powers;
}

std::array<double, kChambers> Circuit::pressureRates(const State& state, double seconds,
                                                     const State& change) const {
  // dP/dt of `instant` by the chain rule: P_peri (sum dV/dt) / scale + de/dt
  // (Ees (V - V0) - a (exp(b (V - V0)) - 1)) + ((1 - e) a b exp(b (V - V0)) + e Ees) dV/dt.
  double heart = fluid_ - room_;
  double heartRate = 0;
  for (std::size_t i = 0; i < kChambers; ++i) {
    heart += state[i];
    heartRate += change[i];
  }
  const double pericardium = kPericardialUnit * std::exp(heart / scale_) * heartRate / scale_;
  std::array<double, kChambers> slopes;
  for (std::size_t i = 0; i < kChambers; ++i) {
    const Chamber& c = pumps_[i].chamber;
    const Activation e = activation(pumps_[i], seconds);
    const double stretch = state[i] - c.v0;
    const double growth = c.a * std::exp(c.b * stretch);
    slopes[i] = pericardium + e.rate * (c.ees * stretch - growth + c.a) +
                ((1 - e.value) * c.b * growth + e.value * c.ees) * change[i];
  }
  return slopes;
}

} // namespace viscera::circulation
