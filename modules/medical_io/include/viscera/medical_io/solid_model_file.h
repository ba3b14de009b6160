#pragma once

#include <filesystem>
#include <string>

#include "viscera/deformation/organ_solid.h"

namespace viscera::medical_io {

/// Writes an organ that is filled with tetrahedra for finite elements, in mm, LPS; the ending says the
/// format.
///
/// * `.inp` (Abaqus, CalculiX): nodes with twelve digits, as CalculiX reads twenty letters of a number at
/// most;
///   elements C3D4; for every wall a node set with its name ("OUTER", "LV") and a surface of the elements'
///   faces
///   ("LV_FACES"), for pressures. Names become capitals, digits and underscores, and different.
/// * `.vtu` (ParaView): for every wall an array at the points, 1 on it and 0 elsewhere.
///
/// Atomic. Throws `CannotCreateError` when the file cannot be written or has another ending. O(n + t).
void writeSolidModel(const std::filesystem::path& file, const deformation::OrganSolid& solid,
                     const std::string& organ);

/// Whether the name ends so that `writeSolidModel` takes it.
bool isSolidModelFile(const std::filesystem::path& file);

} // namespace viscera::medical_io
