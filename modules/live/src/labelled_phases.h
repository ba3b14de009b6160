#pragma once

#include <vector>

#include "viscera/core/progress.h"
#include "viscera/live/cine_motion.h"
#include "viscera/live/motion_series.h"

namespace viscera::live {

/// The labels of some phases of a cycle, in the order given, the outer surface first. Surfaces of which all
/// phases have the same triangles are `corresponding`. Times are not set. Throws what `readMotionSeries`
/// throws of files, labels and cavities; messages name the phases' own numbers.
MotionSeries readLabelledPhases(const std::vector<PhaseLabels>& phases,
                                const std::vector<LabelledSurface>& surfaces, Progress& progress);

} // namespace viscera::live
