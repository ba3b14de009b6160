#pragma once

#include <functional>

#include "nspace/direction_solver.h"

/// The systems of this folder in the plane, each beside its three-dimensional form.
namespace viscera::coordinates {

/// Fills `beta` (n numbers, set to zero before) such that `sum beta_i q_i = 0`; false where there is no
/// answer.
using PlaneBalance = std::function<bool(const SightIn<2>& sight, Values& beta)>;

PlaneBalance planeDeterminants();
PlaneBalance planeGradient(Eigen::Index handles, const ParameterValues& parameters);
/// Throws `UsageError` for the ways that look at all points together.
PlaneBalance planeLagrange(const ParameterValues& parameters);
PlaneBalance planeWire(const ParameterValues& parameters);

} // namespace viscera::coordinates
