#include "viscera/coordinates/celestial/s_celestial.h"

#include <cmath>

#include "celestial/celestial_function.h"

namespace viscera::coordinates {
namespace {

double squaredReach(double t) {
  const double large = std::abs(t) + std::hypot(t, 1.0);
  return t < 0 ? 1 / (large * large) : large * large;
}

double secondDerivative(double t) {
  return 2 * squaredReach(t) / std::hypot(t, 1.0);
}

const CelestialFunction& sFunction() {
  static const CelestialFunction function = [] {
    const simd::CelestialKernels& kernels = *simd::usableCelestialKernels().front();
    return CelestialFunction{squaredReach, secondDerivative, kernels.s2, kernels.s3};
  }();
  return function;
}

} // namespace

SCelestial::SCelestial()
    : CelestialSystem(
          {.id = "s-celestial",
           .name = "S-Celestial",
           .summary = "Smooth and positive, from points alone; the thesis's choice for organs",
           .parameters = {{.name = "lambda",
                           .minimum = 1,
                           .maximum = 1e6,
                           .standard = 1,
                           .help = "The thesis's radius; it cancels in the coordinates and changes nothing",
                           .withoutEffect = true}}},
          sFunction) {}

} // namespace viscera::coordinates
