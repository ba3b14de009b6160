#include "viscera/elasticity/stated_material.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "viscera/elasticity/material.h"
#include "viscera/elasticity/tissues.h"

namespace viscera::elasticity {
namespace {

constexpr double kFoldedValue = std::numeric_limits<double>::quiet_NaN();

/// The middle stretch, between the two others in spite of rounding and of interpolation.
double middleOf(const LocalStretch& at) {
  return std::clamp(at.volumeRatio / (at.largest * at.smallest), at.smallest, at.largest);
}

/// (s - 1) (s + 1): keeps the digits of a stretch near 1.
double squareLessOne(double stretch) {
  return (stretch - 1) * (stretch + 1);
}

} // namespace

StatedMaterial materialOf(std::string_view tissue, double poisson) {
  const Tissue& known = tissueNamed(tissue);
  StatedMaterial material = ownMaterial(known.youngKpa, poisson);
  material.tissue = std::string(known.name);
  return material;
}

StatedMaterial ownMaterial(double youngKpa, double poisson) {
  const NeoHookean checked(youngKpa, poisson); // Throws for what is no material.
  return {{}, youngKpa, poisson};
}

double shearKpa(const StatedMaterial& material) {
  return material.stated() ? material.youngKpa / (2 * (1 + material.poisson)) : kFoldedValue;
}

double vonMisesPerShear(const LocalStretch& at) {
  if (!(at.volumeRatio > 0 && at.smallest > 0 && at.largest >= at.smallest))
    return kFoldedValue;
  // The principal Cauchy stresses are mu / J (s^2 - 1) and the same pressure each, which has no part in it.
  const double a = squareLessOne(at.largest), b = squareLessOne(middleOf(at)), c = squareLessOne(at.smallest);
  return std::sqrt(0.5 * ((a - b) * (a - b) + (b - c) * (b - c) + (c - a) * (c - a))) / at.volumeRatio;
}

double energyPerShear(const LocalStretch& at, double poisson) {
  if (!(at.volumeRatio > 0 && at.smallest > 0 && at.largest >= at.smallest))
    return kFoldedValue;
  const double growth = at.volumeRatio - 1;
  const double bulkPerShear = 2 * poisson / (1 - 2 * poisson);
  return 0.5 * (squareLessOne(at.largest) + squareLessOne(middleOf(at)) + squareLessOne(at.smallest)) -
         std::log1p(growth) + 0.5 * bulkPerShear * growth * growth;
}

} // namespace viscera::elasticity
