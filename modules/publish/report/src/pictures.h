#pragma once

#include <vector>

#include "viscera/report/report.h"
#include "viscera/scene/bulls_eye.h"
#include "viscera/scene/curve_panels.h"

/// Draws the pictures and charts of a report.
namespace viscera::report {

/// The organs as in the view, with its camera; from the front if it has none.
PictureGrid pictureAsSeen(const ReportSource& source, Threads threads);
/// The organs from six sides, in their own colours.
PictureGrid picturesOfSides(const ReportSource& source, Threads threads, Progress& progress);
/// The stress map as in the view.
PictureGrid pictureOfStress(const ReportSource& source, const live::StressFrame& frame, Threads threads);
/// Curves on one pair of axes, as wide as the page.
PictureGrid chart(scene::CurvePanel panel, const std::string& caption);
/// Bull's eyes side by side, as wide as the page.
PictureGrid bullsEyes(std::vector<scene::BullsEyeFigure> figures, const std::string& caption);
/// The colour of a chart's curve: distinguishable from the others.
Vec3 curveColor(std::size_t curve);

} // namespace viscera::report
