#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "viscera/anatomy/norms.h"
#include "viscera/live/strain_reading.h"
#include "viscera/scene/bulls_eye.h"
#include "viscera/scene/curve_panels.h"
#include "viscera/scene/theme.h"

/// Draws the strain of a heart: bull's eyes of its 17 segments, and curves over the cycle.
namespace viscera::presentation {

/// A bull's eye of the segments: values in per cent (white at zero), or times in ms. Segments with too few
/// points are grey; those whose peak is not to be read against the range of healthy adults are hatched, and a
/// note says so. `phase` counts for an instant only. Without any value where the motion has no wall and the
/// direction is radial. All words are English.
scene::BullsEyeFigure strainBullsEye(const live::StrainReading& reading, live::StrainDirection direction,
                                     live::StrainMoment moment, std::size_t phase = 0);

/// The difference of two readings' peaks, `reading` less `before`; hatched where it is smaller than what both
/// fits leave uncertain.
scene::BullsEyeFigure strainDifference(const live::StrainReading& reading, const live::StrainReading& before,
                                       live::StrainDirection direction);

/// "Longitudinal strain", for the language of the reader to translate, like all words of the figures.
const char* titleOf(live::StrainDirection direction);

/// One of GLS, GCS and GRS with its peak, and what healthy adults have.
struct GlobalStrain {
  std::string name; ///< "GLS"
  Vec3 color;       ///< In charts.
  double peakPercent = 0;
  double peakMs = 0;
  anatomy::Range healthyPercent;
  const anatomy::Norm* norm = nullptr; ///< Its people, method and source; never null.
};

/// The ones of the three that are known.
std::vector<GlobalStrain> globalStrains(const live::StrainReading& reading);

/// Curves of length strain (GLS, GCS) and of the strain across the wall (GRS) over the cycle, in per cent,
/// with the bands of healthy adults' peaks. With a segment, 1 to 17, also its curve in that direction,
/// dashed.
scene::CurvePanel strainPanel(const live::StrainReading& reading, int segment = 0,
                              live::StrainDirection direction = live::StrainDirection::longitudinal);

/// Size and colours of a picture of strain.
struct StrainPicture {
  int width = 1600, height = 1200; ///< Pixels.
  scene::Theme theme = scene::lightTheme();
  /// Translates a text into the language of the user; empty: English.
  std::function<std::string(const std::string&)> translate = {};
};

/// The bull's eyes of the peaks above the curves, as a PNG. Needs no display. Throws `CannotCreateError`, and
/// `Error` without OpenGL.
void writeStrainPicture(const std::filesystem::path& file, const live::StrainReading& reading,
                        const StrainPicture& picture = {});

/// Puts the words of a figure into a language.
void translate(scene::BullsEyeFigure& figure, const std::function<std::string(const std::string&)>& words);
void translate(scene::CurvePanel& panel, const std::function<std::string(const std::string&)>& words);

/// The values of a bull's eye on a surface: for each vertex the value of its segment (1 to 17, as
/// `live::StrainGauge::segmentsOn` says), NaN where there is none. With a `chosen` segment that one's alone.
/// O(vertices).
Values strainOnSurface(const scene::BullsEyeFigure& figure, const std::vector<int>& segments, int chosen = 0);

} // namespace viscera::presentation
