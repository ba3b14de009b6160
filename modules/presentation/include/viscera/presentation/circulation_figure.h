#pragma once

#include <string>
#include <vector>

#include "viscera/circulation/beat.h"
#include "viscera/circulation/indices.h"
#include "viscera/circulation/parameters.h"
#include "viscera/core/phrase.h"
#include "viscera/presentation/heart_signs.h"
#include "viscera/scene/curve_panels.h"

namespace viscera::presentation {

/// The solved circulation that a figure draws.
struct ShownCirculation {
  Text name; ///< "Aortic stenosis"
  circulation::Parameters parameters;
  circulation::Beat beat;
  circulation::Indices indices;
};

/// Wiggers's diagram: pressures of the left ventricle, the aorta and the left atrium, when valves are open
/// (`circulation::openTimes`), the left ventricle's volume, electrocardiogram and phonocardiogram over one
/// cycle from before the P wave to after T, below each other in the left part of the window up to `right` (a
/// part of its width). All show the cursor; the first and the second heart sound are marked.
std::vector<scene::CurvePanel> wiggersPanels(const ShownCirculation& shown, double right);

/// The pressure-volume loops of the left and the right ventricle, below each other from `left` on, between
/// the end-systolic and the relaxed relation; those of `before`, when given, are dashed beside them.
std::vector<scene::CurvePanel> loopPanels(const ShownCirculation& shown, const ShownCirculation* before,
                                          double left);

/// The room for a strip, what it shows and the size of its type.
struct StripLook {
  int width = 0, height = 0; ///< Pixels.
  double typeScale = 1;      ///< As that of the theme it is drawn with.
  HeartSigns signs = {};     ///< Nothing is drawn of what is not chosen; the rest shares the room.
};

/// The panels of both figures, arranged for a low and wide window, as under a view: the strips of Wiggers's
/// diagram with a cursor, then the loops of the left and of the right ventricle. Without titles and legends;
/// `circulationLegend` returns the meaning of the colours.
std::vector<scene::CurvePanel> circulationStrip(const ShownCirculation& shown, const ShownCirculation* before,
                                                const StripLook& look);

/// The largest scale of type with which a strip of that many pixels can be read, at most that of a lecture.
double stripTypeScale(int width, int height);

/// Where the instant at `fraction` of the beat that is drawn, in [0, 1], lies in a strip: a line in each
/// panel over the time, a ring on each loop. O(panels).
scene::InstantMarks instantMarks(const std::vector<scene::CurvePanel>& strip, const ShownCirculation& shown,
                                 double fraction);

/// An entry of the legend: the name, colour and style of a curve.
struct CirculationLine {
  Text name;
  Vec3 color;
  bool dashed = false;
};
/// The legend of the strip's curves, in reading order; the entry for `before` is last.
std::vector<CirculationLine> circulationLegend(const ShownCirculation* before);

/// The panels of both figures, arranged in one picture.
std::vector<scene::CurvePanel> circulationFigure(const ShownCirculation& shown,
                                                 const ShownCirculation* before);

} // namespace viscera::presentation
