#pragma once

#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/sequences/stomach_rig.h"

/// Estimates the anatomy of a patient's stomach from its surface and centreline.
namespace viscera::sequences {

/// Length of the standard stomach's centreline from the fundus to the pylorus, mm: stomachs are
/// scaled to this size before they are fitted.
inline constexpr double kStandardStomachLength = 272;
/// Where waves arise, as a part of that way.
inline constexpr double kStandardMidBody = 101.0 / 272.0;

/// Where the pylorus is on a middle line: its first place behind the widest one at which the stomach is
/// narrow and widens again (into the duodenum); the end of the line, less a little, when there is none.
/// `arcs` (mm) and `areas` (mm^2) along the line, of equal length, at least 3. Returns an arc length.
double pylorusAlong(const std::vector<double>& arcs, const std::vector<double>& areas);

/// The anatomy of a stomach of standard size for `makeStomachRig`: handles that do not move hold the part
/// beyond the pylorus and everything else that rings do not reach (the oesophagus). `points` (`n x 3`) are
/// those of the surface. Throws `DataError` when the line leaves the surface or the course does not fit on
/// it.
StomachAnatomy fitStomach(const Centerline& line, const GastricCourse& course, const AnatomySurface& surface,
                          const Points& points);

} // namespace viscera::sequences
