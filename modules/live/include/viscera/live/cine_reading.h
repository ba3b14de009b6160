#pragma once

#include <cstddef>
#include <optional>

#include "viscera/core/phrase.h"
#include "viscera/live/cine_motion.h"
#include "viscera/tracking/fit_quality.h"

/// What a motion from images says of its planes and phases, in words and lights, for tables and views.
namespace viscera::live {

/// Good where a plane was used or its phase has labels; amber where it hardly says anything.
tracking::FitLight lightOf(PlaneState state);

/// What a plane says of a phase: "weight 62 %", "left its plane by 8.4 mm, weight 3 %", "hardly alike, weight
/// 9 %", "shows no wall", "no image", "labelled". Throws `UsageError` for a phase that it has not.
Text wordsOf(const CinePlaneUse& plane, std::size_t phase);

/// The plane of a motion that a slice of its study became; none for one that was not used. O(planes).
std::optional<std::size_t> planeOfSlice(const CineMotion& found, std::size_t slice);

/// The tissue's volume in a phase beside those of the labelled phases.
struct WallCheck {
  double ml = 0;
  tracking::FitLight light = tracking::FitLight::good;
  Text reason; ///< Empty where it is good.
};

/// Checks a phase's wall: muscle hardly changes its volume, so that one 10 % beyond the labels' is amber and
/// 20 % red. `found` is null for a motion whose phases are all labelled, which is its own measure. None
/// without a wall, as of one surface. O(labelled phases).
std::optional<WallCheck> wallAt(const PatientMotion& motion, const CineMotion* found, std::size_t phase);

/// All phases of the cycle as a series without surfaces: names, times, files and volumes, of labelled phases
/// as measured, of the others as the images say. O(phases x surfaces).
MotionSeries wholeCycle(const LabelledStudy& study, const CineMotion& found);

/// The body surface of a study's patient by Mosteller, m2; none where its files do not state height and
/// weight, or those are not of an adult, for whom there are normal ranges.
std::optional<double> statedBodySurface(const medical_io::CineStudy& study);

} // namespace viscera::live
