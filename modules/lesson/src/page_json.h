#pragma once

#include <string>

#include "viscera/lesson/lesson.h"
#include "viscera/lesson/packed_arrays.h"

namespace viscera::lesson {

/// The description of a lesson as the page reads it (docs/lessons.md, "The file"), with its arrays put into
/// `packer`. Copied by list: nothing of the document is in it that the plan does not name. Only ASCII, and
/// none of the characters that end a script element.
std::string pageJson(const Lesson& lesson, ArrayPacker& packer);

} // namespace viscera::lesson
