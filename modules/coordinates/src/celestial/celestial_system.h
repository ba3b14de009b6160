#pragma once

#include <memory>

#include "viscera/coordinates/coordinate_system.h"

namespace viscera::coordinates {

struct CelestialFunction;

/// S- or T-Celestial coordinates (thesis 4.3, 4.4): for each point p the minimum of the convex
/// `F(x) = sum m_i phi(q_i . x)` over the handles' directions `q_i = (v_i - p) / D_i`, with the coordinates
/// `w_i = m_i phi'(q_i . x) / D_i` divided by their sum; only phi differs. Exists and is unique inside the
/// handles' hull, where a damped Newton method finds it from x = 0. A point that lies on the hull's boundary
/// to rounding is bound as well (the coordinates are the limit); one outside has no coordinates and is listed
/// among the failures.
///
/// Beyond the thesis: the locality k gives handles the prior weight `m_i = (D_i / min D)^-k`, floored at
/// 1e-24, so that nearer handles count more; the softness e puts `D_i = sqrt(|v_i - p|^2 + e^2)` for the
/// distance, which makes the coordinates infinitely smooth inside the hull at the price of no longer
/// interpolating handles. Both are 0 in the thesis. Identity (1e-13 of the handles' size, 3e-12 on the hull's
/// boundary), unity and positivity hold for any values.
///
/// All of it is rotation invariant. A point's coordinates are bitwise the same whatever other points are
/// bound with it. Cost of binding: about 8 ns per (point x handle) of one thread (docs/performance.md).
class CelestialSystem final : public DescribedSystem {
public:
  /// Adds the traits to the description, and before its parameters locality and softness. `function` is asked
  /// for when points are bound: it chooses the kernels of the computer's processor.
  CelestialSystem(SystemDescription description, const CelestialFunction& (*function)());

  std::unique_ptr<Binding> bind(const HandleSet& handles, const Points& points, const BindOptions& options,
                                Progress& progress) const override;

  /// The derivatives are in closed form, by the implicit function theorem. Points at a handle have no
  /// derivative without softness (there is a kink): they are among the failures.
  CoordinateGradients gradients(const HandleSet& handles, const Points& points, const BindOptions& options,
                                Progress& progress) const override;

private:
  const CelestialFunction& (*function_)();
};

} // namespace viscera::coordinates
