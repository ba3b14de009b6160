#include <benchmark/benchmark.h>

#include "viscera/circulation/indices.h"
#include "viscera/circulation/periodic_state.h"
#include "viscera/circulation/scenario.h"

/// What a control costs while it moves: the periodic state, from nothing and from a nearby one, with all
/// numbers.
namespace viscera::circulation {
namespace {

void periodicState(benchmark::State& state) {
  const Scenario& scenario = scenarios().at(static_cast<std::size_t>(state.range(0)));
  const Parameters parameters = scenarioParameters(scenario.id);
  state.SetLabel(scenario.id);
  int beats = 0;
  for (auto _ : state) {
    Progress progress;
    const PeriodicState found = findPeriodicState(parameters, progress);
    benchmark::DoNotOptimize(indicesOf(parameters, found.beat));
    beats = found.beats;
  }
  state.counters["beats"] = beats;
}
BENCHMARK(periodicState)->DenseRange(0, 8)->Unit(benchmark::kMillisecond);

void movedControl(benchmark::State& state) {
  Progress progress;
  Parameters parameters;
  State start = findPeriodicState(parameters, progress).start;
  double direction = 1;
  for (auto _ : state) {
    parameters.systemic.resistance *= 1 + 0.02 * direction;
    direction = parameters.systemic.resistance > 1.5   ? -1
                : parameters.systemic.resistance < 0.7 ? 1
                                                       : direction;
    const PeriodicState found = findPeriodicState(parameters, progress, {}, &start);
    start = found.start;
    benchmark::DoNotOptimize(indicesOf(parameters, found.beat));
  }
}
BENCHMARK(movedControl)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace viscera::circulation
