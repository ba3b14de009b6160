#pragma once

#include <string_view>

/// What image files without a word of their own at the beginning are recognised by.
namespace viscera::medical_io {

/// A whole header of a volume of FreeSurfer, which has its version first, and sizes and a type that exist.
bool hasMghMark(std::string_view bytes);

/// A whole header of a GIPL image.
bool hasGiplMark(std::string_view bytes);

} // namespace viscera::medical_io
