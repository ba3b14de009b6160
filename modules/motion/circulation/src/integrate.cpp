#include "integrate.h"

#include <algorithm>

#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>

namespace viscera::circulation {
namespace {

namespace odeint = boost::numeric::odeint;

/// A state with the work of the four chambers and the heat, which are integrated with it: mmHg ml.
constexpr std::size_t kWorks = kChambers + 1;
using StateAndWork = std::array<double, kStateSize + kWorks>;

State stateOf(const StateAndWork& stateAndWork) {
  State state;
  std::copy_n(stateAndWork.begin(), kStateSize, state.begin());
  return state;
}

void reserve(Beat& beat, std::size_t size) {
  const auto all = [size](auto& vectors) {
    for (auto& vector : vectors)
      vector.reserve(size);
  };
  beat.time.reserve(size);
  all(beat.activation);
  all(beat.volume);
  all(beat.pressure);
  all(beat.pressureRate);
  all(beat.flow);
  all(beat.open);
}

void append(Beat& beat, const Circuit& circuit, const State& state, double seconds) {
  const Instant now = circuit.instant(state, seconds);
  State change;
  circuit.rates(state, now, change);
  const auto slopes = circuit.pressureRates(state, seconds, change);
  beat.time.push_back(seconds);
  for (std::size_t i = 0; i < kChambers; ++i) {
    beat.activation[i].push_back(now.activation[i]);
    beat.pressureRate[i].push_back(slopes[i]);
  }
  for (std::size_t i = 0; i < kCompartments; ++i) {
    beat.volume[i].push_back(state[i]);
    beat.pressure[i].push_back(now.pressure[i]);
  }
  for (std::size_t i = 0; i < kValves; ++i) {
    beat.flow[i].push_back(state[kCompartments + i]);
    beat.open[i].push_back(state[kCompartments + kValves + i]);
  }
  beat.pericardium.push_back(now.pericardium);
  beat.systemicFlow.push_back(now.systemicFlow);
  beat.pulmonaryFlow.push_back(now.pulmonaryFlow);
}

} // namespace

State integrateBeat(const Circuit& circuit, const State& start, int steps) {
  State state = start;
  const auto system = [&circuit](const State& y, State& change, double t) {
    circuit.rates(y, circuit.instant(y, t), change);
  };
  // dy/dt = f(y, t) by the classical Runge-Kutta method of fourth order with the step h = period / steps.
  odeint::runge_kutta4<State> stepper;
  const double step = circuit.period() / steps;
  for (int i = 0; i < steps; ++i)
    stepper.do_step(system, state, i * step, step);
  return state;
}

Beat recordBeat(const Circuit& circuit, const State& start, int samples, int substeps) {
  Beat beat;
  beat.period = circuit.period();
  reserve(beat, static_cast<std::size_t>(samples) + 1);
  StateAndWork stateAndWork{};
  std::copy(start.begin(), start.end(), stateAndWork.begin());
  // dW/dt = -P dV/dt beside dy/dt = f(y, t), by the same steps: the energy balance is as accurate as the
  // beat.
  const auto system = [&circuit](const StateAndWork& y, StateAndWork& change, double t) {
    const State state = stateOf(y);
    const Instant now = circuit.instant(state, t);
    State rates;
    circuit.rates(state, now, rates);
    std::copy(rates.begin(), rates.end(), change.begin());
    const auto powers = circuit.powers(state, now, rates);
    std::copy(powers.begin(), powers.end(), change.begin() + kStateSize);
  };
  odeint::runge_kutta4<StateAndWork> stepper;
  const double step = circuit.period() / samples / substeps;
  append(beat, circuit, start, 0);
  for (int i = 1; i <= samples * substeps; ++i) {
    stepper.do_step(system, stateAndWork, (i - 1) * step, step);
    if (i % substeps == 0)
      append(beat, circuit, stateOf(stateAndWork), i * step);
  }
  for (std::size_t i = 0; i < kChambers; ++i)
    beat.work[i] = stateAndWork[kStateSize + i] * kJoulePerMmHgMl;
  beat.dissipated = stateAndWork[kStateSize + kChambers] * kJoulePerMmHgMl;
  return beat;
}

} // namespace viscera::circulation
