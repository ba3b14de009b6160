#pragma once

#include "viscera/lesson/lesson.h"

namespace viscera::lesson {

/// The handles of a lesson that the reader can drag, separate from those of the motion.
struct GripHandles {
  Points positions; ///< `h x 3` mm.
  Table weights;    ///< `h x vertices`.
};

/// Puts up to `count` handles around the organs of a lesson that lie in no other one, and binds all vertices
/// to them and to the corners of a box around (S-Celestial coordinates), which stay where they are. Throws
/// `Cancelled`.
GripHandles gripHandles(const Lesson& lesson, const document::DocumentState& state, int count,
                        Progress& progress, Threads threads);

} // namespace viscera::lesson
