#pragma once

#include "raw_surface.h"

namespace viscera::medical_io {

struct FileBytes;

/// Reads a surface as plain numbers (points, triangles, then both), as a worked example of
/// docs/developer_guide.md. Throws `DataError` that names the line.
RawSurface readPlain(const FileBytes& file);

} // namespace viscera::medical_io
