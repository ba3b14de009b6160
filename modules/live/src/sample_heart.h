#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
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

/// The resolution of the sample heart of which an organ is a surface; none for other organs.
std::optional<sample_organs::Resolution> heartResolutionOf(const document::OrganOrigin& origin);

/// One of the sample heart's surfaces by its name; its errors and cost are `sample_organs::sampleSurface`'s.
std::shared_ptr<const geometry::TriangleMesh> heartSurface(const sample_organs::SampleLibrary& library,
                                                           const char* name,
                                                           sample_organs::Resolution resolution,
                                                           Progress& progress, Threads threads = {});

/// The coronary vessels of the sample heart; its coarsest surface has none, but its picture has those of the
/// next.
std::vector<geometry::NamedVessel> heartVessels(const sample_organs::SampleLibrary& library,
                                                sample_organs::Resolution resolution);

/// The softness of the sample heart's coordinates, a little more than one handle spacing, so that the walls
/// stay smooth between handles (design notes, "Handles that move organs").
inline constexpr double kSoftnessMm = 25;

} // namespace viscera::live
