#pragma once

#include "viscera/medical_io/surface_file.h"

namespace viscera::medical_io {

/// Appends what a user should know before working with the surface: it is open, inside out, in pieces; its
/// size is none that an organ has in mm, with the units that would explain it; its volume is far from the
/// normal one of the organ that its name says. O(m log m).
void appendSurfaceWarnings(SurfaceFile& surface);

} // namespace viscera::medical_io
