#pragma once

#include "viscera/core/arrays.h"
#include "viscera/heart/heart_rig.h"

/// Estimates the anatomy of a heart from its outer surface alone.
namespace viscera::heart {

/// The landmarks of a heart that a user can point at, mm.
struct HeartLandmarks {
  Vec3 apex = Vec3::Zero();  ///< The tip, on the surface.
  Vec3 base = Vec3::Zero();  ///< The middle of the mitral valve, or of the plane of the valves; inside.
  Vec3 right = Vec3::Zero(); ///< Any point on the side of the right ventricle, off the line apex to base.
};

/// Length from base to apex of the standard heart, mm: hearts are scaled to this size before they are fitted.
inline constexpr double kStandardHeartLength = 97;

/// Guesses the landmarks of a heart from its shape. Thin parts (vessels) are told from the body by opening:
/// only what lies near deep points is body. The long axis is the body's principal axis; the apex is at the
/// end away from the vessels, or, without vessels, at the one towards which the body tapers (third moment);
/// the base two thirds of the way back; the right side is where the ventricles reach farthest from the axis,
/// or, when they are round, to the patient's right and front. `surface` is negative inside `box`. Any size.
/// Some 20,000 calls of `surface`. Throws `DataError` when there is no inside.
HeartLandmarks estimateHeartLandmarks(const sequences::AnatomySurface& surface, const Bounds& box);

/// The anatomy of a heart of standard size with those landmarks, for `makeHeartRig` with
/// `HeartRigOptions::cavities` off: the shells of the left ventricle take the width that the surface has on
/// the left, the part behind the base moves as one atrium with the vessels it carries. `points` (`n x 3`) are
/// those of the surface. Throws `DataError` for landmarks on one line or a base that is not inside.
HeartAnatomy fitHeart(const HeartLandmarks& landmarks, const sequences::AnatomySurface& surface,
                      const Points& points);

} // namespace viscera::heart
