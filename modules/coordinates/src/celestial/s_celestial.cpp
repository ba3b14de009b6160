#include "viscera/coordinates/systems.h"

#include <cmath>

#include "celestial/celestial_function.h"
#include "celestial/celestial_system.h"

namespace viscera::coordinates {
namespace {

double squaredReach(double t) {
  const double large = std::abs(t) + std::hypot(t, 1.0);
  return t < 0 ? 1 / (large * large) : large * large;
}

double secondDerivative(double t) {
  return 2 * squaredReach(t) / std::hypot(t, 1.0);
}

} // namespace

const CelestialFunction& sFunction() {
  static const CelestialFunction function = [] {
    const simd::CelestialKernels& kernels = *simd::usableCelestialKernels().front();
    return CelestialFunction{squaredReach, secondDerivative, kernels.s2, kernels.s3};
  }();
  return function;
}

/// S-Celestial coordinates (thesis 4.4): `sum mu_i^2 q_i = 0`, mu_i the distance from the point to the sphere
/// of centre c and radius lambda + |c| along q_i.
///
/// With `s^2 = lambda^2 + 2 lambda |c|` and `x = c / s` this is the convex problem of `CelestialSystem` with
/// `phi'(t) = (t + sqrt(t^2 + 1))^2`: `mu_i = s (t_i + sqrt(t_i^2 + 1))`, and the factor s cancels. So
/// **lambda changes nothing**; the parameter is accepted because users of the thesis expect it.
std::shared_ptr<const CoordinateSystem> sCelestial() {
  return std::make_shared<CelestialSystem>(
      SystemDescription{
          .id = "s-celestial",
          .name = "S-Celestial",
          .summary = "Smooth and positive, from points alone; the thesis's choice for organs",
          .parameters = {{.name = "lambda",
                          .minimum = 1,
                          .maximum = 1e6,
                          .standard = 1,
                          .help = "The thesis's radius; it cancels in the coordinates and changes nothing",
                          .withoutEffect = true}}},
      sFunction);
}

} // namespace viscera::coordinates
