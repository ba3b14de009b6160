#pragma once

#include <iosfwd>

#include "viscera/medical_io/surface_file.h"

class vtkPolyData;

namespace viscera::medical_io {

/// Writes what VTK holds as VTP, with the axes and the name as field data. Throws `CannotCreateError`.
void writeVtp(std::ostream& out, vtkPolyData& data, const WriteSurface& options);

} // namespace viscera::medical_io
