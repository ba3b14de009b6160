#pragma once

#include <string>

#include "viscera/lesson/lesson.h"
#include "viscera/lesson/packed_arrays.h"

namespace viscera::lesson {

/// The description of a lesson as the page reads it (docs/lessons.md, "The file"), with its arrays put into
/// `packer`. It contains only those parts of the document that the plan names. Only ASCII, and none of the
/// characters that end a script element.
std::string pageJson(const Lesson& lesson, ArrayPacker& packer);

} // namespace viscera::lesson
