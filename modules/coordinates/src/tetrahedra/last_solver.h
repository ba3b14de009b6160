#pragma once

#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {

/// `prepare`, which keeps the last solver for the next points that are bound to the same handles, such as
/// those of the next organ and the witness points inside it. For solvers that take seconds to prepare and
/// depend on nothing but positions, cage, parameters and the mesher, which is taken to be always the same.
/// Results are those of `prepare`. The solver stays in memory with the function. Thread-safe: two threads
/// that need the same new solver both prepare it.
///
///     PointwiseSystem(description, keepingTheLastSolver(prepareHarmonic))
PointwiseSystem::PrepareFor keepingTheLastSolver(PointwiseSystem::PrepareFor prepare);

} // namespace viscera::coordinates
