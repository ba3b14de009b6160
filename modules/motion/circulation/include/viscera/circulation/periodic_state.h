#pragma once

#include <string>

#include "viscera/circulation/beat.h"
#include "viscera/circulation/parameters.h"
#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"

namespace viscera::circulation {

/// Tolerance and limits of the search for a periodic state.
struct SolverOptions {
  double tolerance = 1e-7; ///< A beat is periodic when no volume differs by more between its ends, ml.
  int mostBeats = 300;     ///< Gives up after so many.
  int samples = 1000;      ///< Even steps in the curves of a beat; an even number.
  double step = 1e-3;      ///< Of the integration, s, at most.
  bool accelerate = true;  ///< False: integrates beat after beat, as a heart would, which takes some 40 beats
                           ///< and more.
};

/// The result of the search: a periodic beat, or the last one that was tried.
struct PeriodicState {
  bool converged = false;
  int beats = 0;       ///< That were integrated to find it.
  double residual = 0; ///< Largest change of a volume over the last beat, ml.
  State start{};       ///< At the beginning of the ventricles' contraction.
  Beat beat;           ///< From there.
  Text failureReason;  ///< Empty when converged; else the problem and a remedy, in one sentence.
};

/// A state to begin with: the stressed volume spread over the compartments about as at rest. O(1).
State guessedState(const Parameters& parameters);

/// Finds the periodic state: beats are integrated in even steps by the classical Runge-Kutta method
/// (Boost.Odeint) and their fixed point is sought by Anderson's acceleration (Walker and Ni 2011,
/// doi 10.1137/10078356X), whose steps keep the blood volume. `nearby`, when given, is the start of the
/// search: the state for parameters that differ a little, as while a control moves; its volumes are scaled to
/// the stressed volume.
///
/// Takes 5 to 20 ms. Throws `UsageError` for parameters out of range, `Cancelled`. Thread-safe; the result
/// does not depend on the number of threads. A circulation that never settles is no error: `converged` is
/// false.
///
///     const Parameters parameters = scenarioParameters("aortic-stenosis");
///     Progress progress;
///     const PeriodicState found = findPeriodicState(parameters, progress);
///     const double gradient = indicesOf(parameters, found.beat).aorticMeanGradient;
PeriodicState findPeriodicState(const Parameters& parameters, Progress& progress,
                                const SolverOptions& options = {}, const State* nearby = nullptr);

/// Integrates the circulation over a number of beats and returns the state at their end. Throws as
/// `findPeriodicState`.
State afterBeats(const Parameters& parameters, const State& start, int beats, Progress& progress,
                 double step = 1e-3);

/// The blood in all compartments, ml.
double totalVolume(const State& state);

} // namespace viscera::circulation
