#include "viscera/circulation/periodic_state.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "anderson.h"
#include "integrate.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"

namespace viscera::circulation {
namespace {

using Vector = Eigen::VectorXd;

constexpr int kMemory = 8;     ///< Beats that the acceleration mixes.
constexpr int kPlainBeats = 3; ///< Before the acceleration: the guess is far from any beat.
constexpr int kCoarse = 2;     ///< Steps are so many times as long while the state is far off.
constexpr double kNear = 1e-2; ///< Residual, ml, below which beats are integrated exactly.
/// The weights of flows (ml/s) and openings relative to volumes (ml) in the residual.
constexpr double kFlowWeight = 1e-3;
constexpr double kOpeningWeight = 1e-2;

Vector vectorOf(const State& state) {
  return Eigen::Map<const Vector>(state.data(), kStateSize);
}

State stateOf(const Vector& vector) {
  State state;
  Eigen::Map<Vector>(state.data(), kStateSize) = vector;
  return state;
}

Vector weights() {
  Vector weights = Vector::Ones(kStateSize);
  weights.segment(kCompartments, kValves).setConstant(kFlowWeight);
  weights.tail(kValves).setConstant(kOpeningWeight);
  return weights;
}

/// Whether a mixture of states is a state: it may overshoot.
bool plausible(const Vector& x) {
  return x.allFinite() && x.head(kChambers).minCoeff() > 0;
}

bool finite(const State& state) {
  return std::all_of(state.begin(), state.end(), [](double x) { return std::isfinite(x); });
}

double largestChange(const State& a, const State& b) {
  double largest = 0;
  for (std::size_t i = 0; i < kCompartments; ++i)
    largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

Text failureReasonOf(const PeriodicState& found) {
  return phrase(
      "After %n {beat|beats} the volumes still change by %2 ml from beat to beat: strong and weak beats "
      "alternate, or the circulation fails; try a lower rate or a larger stressed volume",
      found.beats, inDigits(found.residual, 2));
}

/// How many steps lie between two samples.
int substepsFor(double period, int samples, double step) {
  return std::max(1, static_cast<int>(std::ceil(period / samples / step - 1e-9)));
}

/// `nearby` for another stressed volume: what is missing or too much goes into the veins, where it is least
/// felt.
State adapted(const State& nearby, double volume) {
  State state = nearby;
  const double missing = volume - totalVolume(nearby);
  double& veins = state[at(Compartment::systemicVeins)];
  if (veins + missing > 0) {
    veins += missing;
    return state;
  }
  for (std::size_t i = 0; i < kCompartments; ++i)
    state[i] *= volume / totalVolume(nearby);
  return state;
}

} // namespace

double totalVolume(const State& state) {
  double sum = 0;
  for (std::size_t i = 0; i < kCompartments; ++i)
    sum += state[i];
  return sum;
}

State guessedState(const Parameters& p) {
  // Volumes at the end of diastole at rest, ml: the four chambers, then the vessels; the systemic veins take
  // what is left.
  constexpr std::array<double, kCompartments> kRest = {130, 137, 55, 60, 130, 0, 75, 58};
  constexpr double kRestTotal = 940;
  constexpr double kHeart = 382;
  constexpr double kFullest =
      2; // Scales of the pericardium, so that its pressure does not start beyond all bounds.
  constexpr double kHighest = 20; // Pressure, mmHg, to which a stiff chamber is filled.
  const double small = std::min(1.0, p.stressedVolume / kRestTotal);
  const double room = p.pericardialRoom + kFullest * p.pericardialScale - p.pericardialFluid;
  const double heart = std::clamp(room / kHeart, 0.1, small);
  const std::array<const Chamber*, kChambers> chambers = {&p.lv, &p.rv, &p.la, &p.ra};
  State state{};
  for (std::size_t i = 0; i < kCompartments; ++i)
    state[i] = small * kRest[i];
  // p = a (exp(b (V - v0)) - 1): a passive chamber at the pressure p holds V = v0 + ln(1 + p / a) / b.
  for (std::size_t i = 0; i < kChambers; ++i)
    state[i] =
        std::min(heart * kRest[i], chambers[i]->v0 + std::log1p(kHighest / chambers[i]->a) / chambers[i]->b);
  state[at(Compartment::systemicVeins)] = p.stressedVolume - totalVolume(state);
  return state;
}

PeriodicState findPeriodicState(const Parameters& parameters, Progress& progress,
                                const SolverOptions& options, const State* nearby) {
  checkParameters(parameters);
  const int substeps = substepsFor(60 / parameters.rate, options.samples, options.step);
  const Circuit circuit(parameters, options.samples * substeps);
  const Vector weight = weights();
  // The periodic state is the fixed point x = P(x) of the map P that integrates one beat.
  Anderson mixture(kMemory);
  PeriodicState found;
  State x = nearby ? adapted(*nearby, parameters.stressedVolume) : guessedState(parameters);
  found.residual = std::numeric_limits<double>::infinity();
  double best = found.residual;
  bool exact = false;
  bool mixed = false;
  while (!found.converged && found.beats < options.mostBeats) {
    progress.throwIfCancelled();
    progress.report(static_cast<double>(found.beats) / options.mostBeats, "beats");
    const State image = integrateBeat(circuit, x, circuit.steps() / (exact ? 1 : kCoarse));
    ++found.beats;
    if (!finite(image) && mixed) { // The mixture went too far: on from the last beat, plainly.
      x = found.start;
      mixture.restart();
      mixed = false;
      continue;
    }
    if (!finite(image))
      throw DataError("the circulation breaks down: its pressures grow without bounds",
                      phrase("beat %1", found.beats),
                      "bring the parameters nearer to those at rest, a few at a time");
    found.residual = largestChange(x, image);
    found.converged = exact && found.residual < options.tolerance;
    found.start = image;
    const bool plain = !options.accelerate || found.beats <= kPlainBeats;
    if (!exact && found.residual < kNear) {
      exact = true; // The coarse images do not fit those to come.
      mixture.restart();
    } else if (found.residual > 4 * best) {
      mixture.restart();
    }
    best = std::min(best, found.residual);
    const Vector next = plain ? vectorOf(image) : mixture.next(vectorOf(x), vectorOf(image), weight);
    mixed = !plain && plausible(next);
    x = mixed ? stateOf(next) : image;
    for (std::size_t i = kCompartments + kValves; i < kStateSize; ++i)
      x[i] = std::clamp(x[i], 0.0, 1.0);
  }
  found.beat = recordBeat(circuit, found.start, options.samples, substeps);
  ++found.beats;
  if (!found.converged)
    found.failureReason = failureReasonOf(found);
  return found;
}

State afterBeats(const Parameters& parameters, const State& start, int beats, Progress& progress,
                 double step) {
  checkParameters(parameters);
  const Circuit circuit(parameters, substepsFor(60 / parameters.rate, 1, step));
  State state = start;
  for (int i = 0; i < beats; ++i) {
    progress.throwIfCancelled();
    state = integrateBeat(circuit, state, circuit.steps());
  }
  return state;
}

} // namespace viscera::circulation
