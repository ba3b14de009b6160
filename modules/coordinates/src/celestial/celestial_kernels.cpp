#include "celestial/celestial_kernels.h"

#include "celestial/celestial_functions.h"
#include "celestial/pack_solver.h"

namespace viscera::coordinates::simd::VISCERA_ISA {
namespace {

template <class Function, int Dim, bool Prior>
unsigned solvePacks(const CelestialProblem& problem, const double* points, double* scratch, double* tile,
                    double* solutions) {
  unsigned failed = 0;
  for (int first = 0; first < kTile; first += kWidth) {
    PackSolver<Function, Dim, Prior> solver(problem, points + first, scratch);
    failed |= bits(solver.solve(tile + first)) << first;
    solver.writeSolutions(solutions + first);
  }
  return failed;
}

template <class Function, int Dim>
unsigned solveTile(const CelestialProblem& problem, const double* points, double* scratch, double* tile,
                   double* solutions) {
  return problem.locality > 0 ? solvePacks<Function, Dim, true>(problem, points, scratch, tile, solutions)
                              : solvePacks<Function, Dim, false>(problem, points, scratch, tile, solutions);
}

} // namespace

extern const CelestialKernels kCelestialKernels;
const CelestialKernels kCelestialKernels = {solveTile<SFunction, 2>, solveTile<SFunction, 3>,
                                            solveTile<TFunction, 2>, solveTile<TFunction, 3>};

} // namespace viscera::coordinates::simd::VISCERA_ISA
