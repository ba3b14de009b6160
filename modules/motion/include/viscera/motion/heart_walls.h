#pragma once

#include <optional>

#include "viscera/motion/motion_runner.h"
#include "viscera/sequences/wall_motion.h"

namespace viscera::motion {

/// Measures how the walls of the sample heart move in a sequence, on the surfaces of left and right cavity
/// ("lv", "rv") and the surface around them. For the runner's thread.
class HeartWalls {
public:
  /// Finds the walls; `runner` must live longer.
  explicit HeartWalls(const MotionRunner& runner);

  /// Where the walls are in the pose shown last; empty if no sample heart beats, and if the surfaces are too
  /// coarse to be measured. O(vertices).
  std::optional<sequences::WallPlaces> now() const;

private:
  const MotionRunner& runner_;
  document::OrganId left_, right_, outer_;
  std::optional<sequences::WallGauge> gauge_;
};

} // namespace viscera::motion
