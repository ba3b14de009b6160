#pragma once

#include "circuit.h"

namespace viscera::circulation {

/// The state one beat later, by `steps` even steps of the classical Runge-Kutta method of fourth order. Even
/// ones, because then the beat is a smooth function of its start, which is what a search for a fixed point
/// needs.
State integrateBeat(const Circuit& circuit, const State& start, int steps);

/// The same beat with all its curves at `samples` even instants, `substeps` steps between them.
Beat recordBeat(const Circuit& circuit, const State& start, int samples, int substeps);

} // namespace viscera::circulation
