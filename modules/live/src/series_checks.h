#pragma once

#include "viscera/live/motion_series.h"

/// Checks of a series before its motion is tracked. All throw `DataError` whose text names a remedy.
namespace viscera::live {

/// How far two phases lie apart on average, mm: of points where they correspond, else of what one surface has
/// and the other has not, by its area.
double apartMm(const MotionSeries& series, std::size_t a, std::size_t b);

/// Fewer than four phases.
void requirePhases(std::size_t count);
/// Volumes that are not positive, or jump by more than half of the largest between neighbours.
void requireSteadyVolumes(const MotionSeries& series);
/// Cavities that are not inside the outer surface, in the first phase.
void requireCavitiesInside(const MotionSeries& series);
/// Phases, or surfaces, of which one is in RAS where another is in LPS, by where they are.
void requireOneSpace(const MotionSeries& series);
/// A loop whose last phase does not lead back to the first.
void requireClosedLoop(const MotionSeries& series);

} // namespace viscera::live
