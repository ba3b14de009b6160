#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <optional>

#include "viscera/core/phrase.h"
#include "viscera/medical_io/surface_file.h"

namespace viscera::medical_io {

/// Parses the axes in a comment of a file: `SPACE=RAS` or `SPACE=LPS`, as 3D Slicer writes it. Unknown axes
/// add a warning.
std::optional<Space> findSpace(std::string_view comment, std::vector<Text>& warnings);

/// The one-line comment that Viscera writes: program, name and axes. Line ends in the name become spaces, and
/// the name is cut so that the comment has at most `longest` bytes.
std::string writtenComment(const WriteSurface& options, std::size_t longest = 240);

/// The name in such a comment; empty if another program wrote it.
std::string nameInComment(std::string_view comment);

/// "LPS" or "RAS".
std::string_view spaceName(Space space);

} // namespace viscera::medical_io
