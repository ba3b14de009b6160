#pragma once

#include <filesystem>

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/lesson/lesson_plan.h"
#include "viscera/live/posed_organs.h"

namespace viscera::lesson {

/// The size and contents of a glTF file that was written.
struct WrittenGltf {
  std::size_t bytes = 0;
  std::size_t modes = 0;     ///< Morph targets of each surface.
  std::size_t frames = 0;    ///< Keys of a cycle, the closing one left out.
  double largestErrorMm = 0; ///< Of a vertex, at and between keys.
};

/// Writes the organs of a plan with their motion at `plan.rate` as glTF 2.0, binary: a node and a mesh a
/// surface, morph targets (positions), one animation of their weights, y up, metres. Where that takes more
/// than `kMostGltfBytes`, modes are left out as long as no vertex is off by more than half a millimetre.
/// Names are those of the plan. Still organs have no animation. Atomic. Throws as `makeLesson`, and
/// `CannotCreateError`.
WrittenGltf writeAnimatedGltf(const std::filesystem::path& file, const LessonPlan& plan,
                              const LessonSource& source, live::PosedOrgans& organs, Progress& progress,
                              Threads threads = {});

inline constexpr std::size_t kMostGltfBytes = 3'000'000;

} // namespace viscera::lesson
