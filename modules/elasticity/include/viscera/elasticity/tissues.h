#pragma once

#include <span>
#include <string>
#include <string_view>

#include <Eigen/Core>

#include "viscera/elasticity/material.h"

/// The stiffness of tissues as measured, and stress in pascals for a stated material.
namespace viscera::elasticity {

/// The stiffness of a healthy human tissue at small strains.
struct Tissue {
  std::string_view name;    ///< "liver"
  std::string_view organ;   ///< The id of its organ in the table of `anatomy`: "heart" of "myocardium".
  double youngKpa;          ///< Three times the shear modulus where that was measured.
  std::string_view measure; ///< What was measured, with its spread.
  std::string_view doi;     ///< Of the publication.
};

/// The tissues whose stiffness is known here, by name.
std::span<const Tissue> tissues();

/// The tissue of that name, else of the organ that the name means to `anatomy::partNamed`: "Leber" and
/// "kidney_left" have one, lesions and the cavities of the heart have none. Throws `UsageError` that lists
/// those that there are. O(length).
const Tissue& tissueNamed(std::string_view name);

/// The von Mises equivalent of the Cauchy stress of `material` at the deformation gradient `f`, kPa. The
/// pressure that keeps the volume has no part in it, so that it exists also for gradients of handles' poses,
/// which do not keep it. NaN where `f` turns the tissue inside out. O(1), thread-safe.
///
///     const NeoHookean liver(tissueNamed("liver").youngKpa, 0.49);
///     const double kpa = vonMisesKpa(liver, Eigen::Vector3d(1.1, 1, 1).asDiagonal());
double vonMisesKpa(const Material& material, const Eigen::Matrix3d& f);

} // namespace viscera::elasticity
