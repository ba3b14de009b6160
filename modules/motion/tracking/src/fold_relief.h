#pragma once

#include "viscera/tracking/volume_equality.h"
#include "wall_stiffness.h"

namespace viscera::tracking {

/// Whether det F <= 0 at a witness. O(witnesses x handles).
bool isFolded(const WallStiffness& stiffness, const Points& pose);

/// Takes the folds out of a pose: Newton's method on det F = 0.05 at all witnesses that are or were flatter,
/// at once, along the directions of a metric, which cost the fit least; the volumes of the surfaces stay what
/// they are where `keepVolumes`, along directions that leave det F there. Whether no witness is folded
/// afterwards; otherwise, and where none was, `pose` is as it was. Deterministic. O(rounds x witnesses x
/// handles).
bool relieveFolds(const MotionRig& rig, const WallStiffness& stiffness, const Metric& metric,
                  bool keepVolumes, Points& pose);

} // namespace viscera::tracking
