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

} // namespace

std::string SCelestial::summary() const {
  return "Smooth and positive, from points alone; the thesis's choice for organs";
}

std::vector<Parameter> SCelestial::parameters() const {
  std::vector<Parameter> parameters = CelestialSystem::parameters();
  Parameter lambda;
  lambda.name = "lambda";
  lambda.minimum = 1;
  lambda.maximum = 1e6;
  lambda.standard = 1;
  lambda.help = "The thesis's radius; it cancels in the coordinates and changes nothing";
  parameters.push_back(lambda);
  return parameters;
}

const CelestialFunction& SCelestial::function() const {
  static const CelestialFunction function = [] {
    const simd::CelestialKernels& kernels = *usableCelestialKernels().front();
    return CelestialFunction{squaredReach, secondDerivative, kernels.s2, kernels.s3};
  }();
  return function;
}

} // namespace viscera::coordinates
