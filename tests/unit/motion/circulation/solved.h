#pragma once

#include "viscera/circulation/indices.h"
#include "viscera/circulation/periodic_state.h"
#include "viscera/circulation/scenario.h"

namespace viscera::circulation {

/// A solved circulation with its computed numbers, for tests.
struct Solved {
  Parameters parameters;
  PeriodicState state;
  Indices indices;
};

inline Solved solve(const Parameters& parameters, const SolverOptions& options = {}) {
  Progress quiet;
  Solved solved{parameters, findPeriodicState(parameters, quiet, options), {}};
  solved.indices = indicesOf(parameters, solved.state.beat);
  return solved;
}

inline Solved solve(const std::string& scenario) {
  return solve(scenarioParameters(scenario));
}

} // namespace viscera::circulation
