#include "viscera/coordinates/systems.h"

#include <cmath>

#include "celestial/celestial_function.h"
#include "celestial/celestial_system.h"

namespace viscera::coordinates {
namespace {
double exponential(double t) {
  return std::exp(t);
}

} // namespace

const CelestialFunction& tFunction() {
  static const CelestialFunction function = [] {
    const simd::CelestialKernels& kernels = *simd::usableCelestialKernels().front();
    return CelestialFunction{exponential, exponential, kernels.t2, kernels.t3};
  }();
  return function;
}

/// T-Celestial coordinates (thesis 4.3): `sum exp(psi . q_i) q_i = 0`, the convex problem of
/// `CelestialSystem` with `phi(t) = exp(t)`. The thesis calls them dependent on rotation; solved to the end
/// they are not (the tests measure it).
std::shared_ptr<const CoordinateSystem> tCelestial() {
  return std::make_shared<CelestialSystem>(
      SystemDescription{.id = "t-celestial",
                        .name = "T-Celestial",
                        .summary = "Smooth and positive, from points alone; maximum entropy over directions"},
      tFunction);
}

} // namespace viscera::coordinates
