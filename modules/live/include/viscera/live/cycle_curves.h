#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/heart/wall_motion.h"
#include "viscera/live/motion_runner.h"

namespace viscera::live {

/// The volumes of organs over one whole cycle of a sequence, computed without playing it: no frame has to be
/// played for a curve, an extreme or an ejection fraction.
///
///     PosedCopy organs = live.copy();
///     MotionRunner runner(state, organs);
///     runner.setSequence(sequence);
///     const CycleCurves curves = measureCycle(runner, progress);
struct CycleCurves {
  std::vector<double> fractions;                ///< Of the cycle, ascending, from 0 to 1.
  std::vector<std::vector<double>> milliliters; ///< For each organ of the document one number an instant; an
                                                ///< open surface has zeros.
  /// How the walls move, measured on the surfaces, where a sample heart beats; none of other organs.
  std::optional<heart::WallMotion> wall;
  Text obstacle; ///< Why a locked or prescribed volume could not be kept somewhere; else empty.
};

/// Poses the runner's organs at 96 evenly spaced instants of a cycle and where its phases begin, so that the
/// corners of the curves are met, and measures them: the same numbers as `MotionRunner::volumesMl` gives
/// there. Throws `UsageError` when the runner cannot move the handles, what `show` throws, and `Cancelled`.
/// O(instants) frames.
CycleCurves measureCycle(MotionRunner& runner, Progress& progress);

} // namespace viscera::live
