#pragma once

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/lesson/lesson.h"

namespace viscera::lesson {

/// The walls of the plan's heart, of a lesson that has its vertices, modes and handles already. Throws
/// `Cancelled`.
LessonTissue tissueOf(const Lesson& lesson, const LessonSource& source, Progress& progress, Threads threads);

/// The heart's conduction system with the excitation at the plan's rates. Throws `Cancelled`.
LessonConduction conductionOf(const Lesson& lesson, const LessonSource& source, Progress& progress,
                              Threads threads);

} // namespace viscera::lesson
