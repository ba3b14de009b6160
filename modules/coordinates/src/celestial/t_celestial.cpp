#include "viscera/coordinates/celestial/t_celestial.h"

#include <cmath>

#include "celestial/celestial_function.h"

namespace viscera::coordinates {
namespace {
double exponential(double t) {
  return std::exp(t);
}
const CelestialFunction& tFunction() {
  static const CelestialFunction function = [] {
    const simd::CelestialKernels& kernels = *simd::usableCelestialKernels().front();
    return CelestialFunction{exponential, exponential, kernels.t2, kernels.t3};
  }();
  return function;
}

} // namespace

TCelestial::TCelestial()
    : CelestialSystem({.id = "t-celestial",
                       .name = "T-Celestial",
                       .summary = "Smooth and positive, from points alone; maximum entropy over directions"},
                      tFunction) {}

} // namespace viscera::coordinates
