#pragma once

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/lesson/lesson.h"

namespace viscera::lesson {

/// Points that the vertices of some of a lesson's surfaces carry (`geometry::CarriedPoints`).
struct PartsToCarry {
  Points rest;                       ///< `n x 3` mm.
  std::vector<std::size_t> surfaces; ///< Places among the lesson's surfaces.
  std::vector<const Points*> meshes; ///< Their vertices at rest, as exact as the document has them.
};

/// Says of each point which four vertices of the lesson carry it, and how: the choice that comes nearest to
/// the motion that all the vertices give it, with the lesson's modes and handles, in steps of
/// `kCarriedStep`. The parts follow a common shift exactly. Some 0.1 ms a point. Throws `Cancelled`.
CarriedParts carriedParts(const PartsToCarry& parts, const Lesson& lesson, Progress& progress,
                          Threads threads);

} // namespace viscera::lesson
