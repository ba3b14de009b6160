#pragma once

#include <string>
#include <string_view>

/// Stress and energy of tissue from its stretches alone, in pascals of a material that is stated.
namespace viscera::elasticity {

/// Poisson's ratio where no other one is stated: nearly incompressible.
inline constexpr double kUsualPoisson = 0.49;

/// A neo-Hookean material that a user has chosen: a tissue of the table, or Young's modulus. Without one
/// there are no pascals.
struct StatedMaterial {
  std::string tissue;  ///< Of `tissues()`; empty where the modulus is the user's own.
  double youngKpa = 0; ///< 0: no material is stated.
  double poisson = kUsualPoisson;

  bool stated() const { return youngKpa > 0; }
  bool operator==(const StatedMaterial&) const = default;
};

/// The material of a tissue of the table. Throws `UsageError` for a tissue that is not there, and for a
/// Poisson's ratio that is not above 0 and below 0.5.
StatedMaterial materialOf(std::string_view tissue, double poisson = kUsualPoisson);
/// A material of the user's own. Throws `UsageError` for a modulus that is not above 0 kPa, and as above.
StatedMaterial ownMaterial(double youngKpa, double poisson = kUsualPoisson);

/// A local deformation by its singular values: the largest, the smallest, and the product of all three.
struct LocalStretch {
  double largest = 1;
  double smallest = 1;
  double volumeRatio = 1; ///< At most 0 where the tissue is folded.
};

/// The von Mises equivalent of the Cauchy stress, by the shear modulus, without unit: it depends on the
/// stretches only. NaN where the tissue is folded. O(1), thread-safe.
double vonMisesPerShear(const LocalStretch& at);
/// The strain energy per volume at rest, by the shear modulus, without unit. NaN where the tissue is folded.
double energyPerShear(const LocalStretch& at, double poisson);

/// The shear modulus, kPa; NaN where no material is stated, so that no pascals come of none.
double shearKpa(const StatedMaterial& material);

/// The von Mises stress, kPa. The closed form of `vonMisesKpa(NeoHookean, F)` in F's singular values.
///
///     const StatedMaterial liver = materialOf("liver");
///     const double kpa = vonMisesKpa(liver, {1.1, 1, 1.1});
inline double vonMisesKpa(const StatedMaterial& material, const LocalStretch& at) {
  return shearKpa(material) * vonMisesPerShear(at);
}
/// The strain energy per volume at rest with the part that the change of volume takes, kPa (= mJ/ml).
inline double energyKpa(const StatedMaterial& material, const LocalStretch& at) {
  return shearKpa(material) * energyPerShear(at, material.poisson);
}

} // namespace viscera::elasticity
