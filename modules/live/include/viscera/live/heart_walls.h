#pragma once

#include <optional>

#include "viscera/heart/wall_motion.h"
#include "viscera/live/motion_runner.h"

namespace viscera::live {

/// Measures how the walls of the sample heart move in a sequence, on the surfaces of left and right cavity
/// ("lv", "rv") and the surface around them. For the runner's thread.
class HeartWalls {
public:
  /// Finds the walls; `runner` must live longer.
  explicit HeartWalls(const MotionRunner& runner);

  /// Where the walls are in the pose shown last; empty if no sample heart beats, and if the surfaces are too
  /// coarse to be measured. O(vertices).
  std::optional<heart::WallPlaces> now() const;

private:
  const MotionRunner& runner_;
  document::OrganId left_, right_, outer_;
  std::optional<heart::WallGauge> gauge_;
};

} // namespace viscera::live
