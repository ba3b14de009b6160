#pragma once

#include <vector>

#include <Eigen/Core>

#include "viscera/core/arrays.h"

/// Strain of the tissue at a point.
namespace viscera::strain {

/// The local axes of the wall at a point: unit and orthogonal, `circumferential = longitudinal x radial`.
struct LocalAxes {
  Vec3 radial = Vec3::UnitX();       ///< From the endocardium outward.
  Vec3 longitudinal = Vec3::UnitZ(); ///< Along the wall towards the base.
  Vec3 circumferential = Vec3::UnitY();
};

/// The axes with that radial direction, and the longitudinal one made orthogonal to it. Neither may be zero.
LocalAxes localAxes(const Vec3& radial, const Vec3& towardsBase);

/// The axes in a deformed body of the material directions that are `axes` at rest: the wall's normal moves by
/// the inverse transpose of the deformation gradient `m`, the longitudinal direction by `m`. Where `m` has no
/// inverse the axes stay.
LocalAxes carriedAxes(const LocalAxes& axes, const Eigen::Matrix3d& m);

/// The Green-Lagrange strain `E = (M'M - I) / 2` along local axes, without unit.
struct WallStrain {
  double radial = 0, circumferential = 0, longitudinal = 0;
  double circumferentialLongitudinal = 0, circumferentialRadial = 0, longitudinalRadial = 0;
};

/// The strain of the deformation gradient `m`. Exact up to rounding.
WallStrain strainAlong(const Eigen::Matrix3d& m, const LocalAxes& axes);

/// The change of a length by its Green-Lagrange strain, `sqrt(1 + 2 E) - 1`: what clinics call strain. -1 for
/// values that no deformation has.
double engineering(double greenLagrange);

} // namespace viscera::strain
