#pragma once

#include <optional>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/heart/heart_rig.h"

namespace viscera::heart {

/// The volumes of the atria relative to rest, where they are known.
struct AtrialState {
  double leftPart = 1; ///< Volume of the left atrium as a fraction of that at rest.
  double rightPart = 1;
  /// What is added to the displacement of the atrium's walls, as a part of their distance from its centre.
  /// `CavityFit` finds it; 0 before.
  double leftShift = 0;
  double rightShift = 0;
};

/// The state of a heart's motion at one instant of its beat.
struct HeartState {
  double emptying = 0;          ///< Of the left ventricle: 0 at the end of diastole at rest, 1 of systole.
  double rightEmptying = 0;     ///< The same of the right one.
  double leftPart = 1;          ///< Volume of the left ventricle as a fraction of that at rest.
  double rightPart = 1;         ///< The same of the right one.
  double twist = 0;             ///< Part of the largest twist.
  double atrialContraction = 0; ///< 0 to 1; without effect where `atria` are known.
  std::optional<AtrialState> atria;
  double muscle = 1; ///< The volume of the left ventricle's muscle, as a part of that at rest.
  /// The left cavity's radius as a multiple of that which follows from its volume. `CavityFit` finds it; 1
  /// before.
  double leftGain = 1;
  /// What is added to the right cavity's thickness, as a part of that at rest. `CavityFit` finds it; 0
  /// before.
  double rightShift = 0;
};

/// The amplitudes with which the parts of a heart move.
struct HeartExcursions {
  double leftDescent = 12.5;       ///< Of the base at the left free wall, mm; the whole annulus comes to 15.5
                                   ///< (16.4: doi 10.1152/ajpheart.01376.2006).
  double rightDescent = 21.5;      ///< Of the base at the right free wall, mm (23.4 mm, same source).
  double baseTwist = -0.070;       ///< Turn at the base, rad.
  double apexTwist = 0.175;        ///< Turn at the apex, rad.
  double atrialContraction = 0.12; ///< Part by which an atrium narrows when it contracts.
  /// Part by which it widens while the ventricles empty. So chosen that the whole heart loses 8 to 9 % of its
  /// volume in systole (8.2 %, 4.8 to 10.6: doi 10.1152/ajpheart.01125.2003).
  double atrialFilling = 0.10;
};

/// Computes the pose of a heart's handles for a state of its beat.
///
/// The base descends towards the apex, which does not move; the left cavity narrows; the wall of the left
/// ventricle thickens so that its volume stays (rho'^2 = (f rho_en)^2 + m (rho^2 - rho_en^2) / lambda, with f
/// the cavity's scale, lambda the shortening of the long axis and m the muscle there is); the right
/// ventricle's free wall follows the septum and comes closer to it, least near its outflow; the ventricles
/// twist; the atria lengthen with the descent, fill, and contract; the vessels give way near their roots.
/// Atria whose volumes are known move what is around them as sources and sinks of blood would, so that walls
/// keep their volume. Immutable; thread-safe.
class HeartMotion {
public:
  explicit HeartMotion(HeartRig rig, const HeartExcursions& excursions = {});

  const HeartRig& rig() const { return rig_; }

  /// Fills `pose` (resized to `n x 3`). O(n).
  void pose(const HeartState& state, Points& pose) const;

  /// The length of the ventricle's long axis as a part of that at rest (lambda).
  double shortening(const HeartState& state) const;

  /// The scale of the left cavity's radius (f) at which an ellipsoid, so shortened, holds the state's volume.
  double leftScale(const HeartState& state) const;

  /// The distance from the axis to which a point of the left ventricle's wall moves that rests at `rho` and
  /// `c`, mm.
  double wallRho(const HeartState& state, double rho, double c) const;

  /// How far towards the apex a point of the ventricles moves that rests at `phi` and `c`, mm.
  double descent(const HeartState& state, double phi, double c) const;

private:
  Vec3 moved(std::size_t row, const HeartState& state) const;
  Vec3 movedVentricular(const HeartHandle& handle, const HeartState& state) const;
  Vec3 movedAtrial(std::size_t row, const HeartState& state) const;
  /// How far the atria push a handle that rests outside the ventricles, mm.
  Vec3 pushedByAtria(std::size_t row, const AtrialState& atria) const;
  /// What the left ventricle's wall is thicker at `c` than at rest, mm; not negative.
  double thickening(const HeartState& state, double c) const;
  double ventricularRho(const HeartHandle& handle, const HeartState& state) const;

  HeartRig rig_;
  HeartExcursions excursions_;
  /// The volume of an atrium's body, by atrium and handle, by that of the sphere through the handle around
  /// it, 1 inside the atrium.
  std::vector<std::vector<double>> atrialShares_;
  bool wallsHandled_; ///< The cavities' walls have handles of their own.
};

} // namespace viscera::heart
