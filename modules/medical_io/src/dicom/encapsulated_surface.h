#pragma once

#include "file_bytes.h"
#include "raw_surface.h"

namespace viscera::medical_io {

/// The surface in a DICOM file that has an STL or OBJ file within (PS3.3, A.85), with its title, unit and
/// colour. Its axes are those of the patient, LPS, unless the file within says otherwise. Throws `DataError`
/// that names the kind of any other DICOM object, and as the readers of STL and OBJ.
RawSurface readDicomSurface(const FileBytes& file);

} // namespace viscera::medical_io
