#include "viscera/coordinates/celestial/t_celestial.h"

#include <cmath>

#include "celestial/celestial_function.h"

namespace viscera::coordinates {
namespace {
double exponential(double t) {
  return std::exp(t);
}
} // namespace

std::string TCelestial::summary() const {
  return "Smooth and positive, from points alone; maximum entropy over directions";
}

const CelestialFunction& TCelestial::function() const {
  static const CelestialFunction function = [] {
    const simd::CelestialKernels& kernels = *usableCelestialKernels().front();
    return CelestialFunction{exponential, exponential, kernels.t2, kernels.t3};
  }();
  return function;
}

} // namespace viscera::coordinates
