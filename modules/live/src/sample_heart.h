#pragma once

#include "viscera/core/parallel.h"
#include "viscera/document/document.h"
#include "viscera/heart/heart_motion.h"
#include "viscera/sample_organs/sample_organ.h"
#include "viscera/sequences/pose_compensation.h"

namespace viscera::live {

/// The handles that make the sample heart beat, at rest and in motion, and the coordinates that tie it to
/// them.
struct SampleHeart {
  document::SystemChoice system;
  heart::HeartMotion motion;
  Points rest; ///< `n x 3` mm
  sequences::PoseCompensation compensation;
};

/// Makes those of the library's heart. Some 0.1 s.
SampleHeart sampleHeart(const sample_organs::SampleLibrary& library, Threads threads);

/// The softness of the sample heart's coordinates, a little more than one handle spacing, so that the walls
/// stay smooth between handles (design notes, "Handles that move organs").
inline constexpr double kSoftnessMm = 25;

} // namespace viscera::live
