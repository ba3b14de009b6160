#pragma once

#include <cstddef>

#include "viscera/live/strain_reading.h"
#include "viscera/scene/bulls_eye.h"
#include "viscera/scene/curve_panels.h"

/// Draws the strain of a heart: bull's eyes of its 17 segments, and curves over the cycle.
namespace viscera::presentation {

/// A bull's eye of the segments: values in per cent (white at zero), or times in ms. Segments with too few
/// points are grey, those that are not to be relied on hatched. `phase` counts for an instant only. Without
/// any value where the motion has no wall and the direction is radial. All words are English.
scene::BullsEyeFigure strainBullsEye(const live::StrainReading& reading, live::StrainDirection direction,
                                     live::StrainMoment moment, std::size_t phase = 0);

/// The difference of two readings' peaks, `reading` less `before`.
scene::BullsEyeFigure strainDifference(const live::StrainReading& reading, const live::StrainReading& before,
                                       live::StrainDirection direction);

/// Curves of length strain (GLS, GCS) and of the strain across the wall (GRS) over the cycle, in per cent.
scene::CurvePanel strainPanel(const live::StrainReading& reading);

} // namespace viscera::presentation
