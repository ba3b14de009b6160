#include "viscera/elasticity/tissues.h"

#include <array>
#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "viscera/anatomy/part.h"
#include "viscera/core/error.h"

namespace viscera::elasticity {
namespace {

constexpr std::array<Tissue, 6> kTissues = {{
    {"liver", "liver", 6.27,
     "shear stiffness 2.09 +- 0.22 kPa, magnetic resonance elastography, 41 healthy adults",
     "10.1002/jmri.24084"},
    {"myocardium", "heart", 7.77,
     "shear stiffness at the end of diastole 2.59 +- 0.58 kPa, shear-wave ultrasound, 20 healthy adults of "
     "20 to "
     "39 years; 6.08 +- 1.06 kPa at 60 to 79",
     "10.1016/j.jcmg.2018.02.002"},
    {"kidney", "kidney", 5.0,
     "Young's modulus of the cortex 5.0 +- 2.9 kPa, shear-wave ultrasound, healthy adults",
     "10.2214/AJR.10.5449"},
    {"spleen", "spleen", 2.9, "Young's modulus 2.9 +- 1.8 kPa, shear-wave ultrasound, healthy adults",
     "10.2214/AJR.10.5449"},
    {"pancreas", "pancreas", 4.8, "Young's modulus 4.8 +- 3 kPa, shear-wave ultrasound, healthy adults",
     "10.2214/AJR.10.5449"},
    {"stomach", "stomach", 1.911,
     "quasistatic shear modulus 0.637 kPa, a table of values from the literature",
     "10.1088/1361-6560/ab5010"},
}};

/// The organ that a name means, if it may have a tissue; else empty.
std::string_view organOf(std::string_view name) {
  const auto part = anatomy::partNamed(name);
  if (!part || part->extent == anatomy::Extent::lesion || anatomy::chamberNamed(name))
    return {};
  return part->organ;
}

} // namespace

std::span<const Tissue> tissues() {
  return kTissues;
}

const Tissue& tissueNamed(std::string_view name) {
  std::string known;
  for (const Tissue& tissue : kTissues) {
    if (tissue.name == name)
      return tissue;
    known += (known.empty() ? "" : ", ") + std::string(tissue.name);
  }
  if (const std::string_view organ = organOf(name); !organ.empty())
    for (const Tissue& tissue : kTissues)
      if (tissue.organ == organ)
        return tissue;
  throw UsageError(diagnostic("the stiffness of %1 is not known", std::string(name)), {},
                   diagnostic("choose one of %1, or give Young's modulus", known));
}

double vonMisesKpa(const Material& material, const Eigen::Matrix3d& f) {
  const double j = f.determinant();
  if (!(j > 0))
    return std::numeric_limits<double>::quiet_NaN();
  const Eigen::Matrix3d stress = material.respond(f).stress * f.transpose() / j;
  const Eigen::Matrix3d deviator = stress - stress.trace() / 3 * Eigen::Matrix3d::Identity();
  return std::sqrt(1.5) * deviator.norm();
}

} // namespace viscera::elasticity
