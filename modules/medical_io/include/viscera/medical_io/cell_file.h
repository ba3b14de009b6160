#pragma once

#include <filesystem>
#include <optional>

#include "viscera/deformation/witness_mesh.h"

namespace viscera::medical_io {

/// The cells of a volume mesh (VTU, VTK, gmsh, medit, openCARP) as tetrahedra in mm and LPS, whose inner
/// corners are witness points. Other cells are cut into tetrahedra. None for a file without cells and for a
/// mesh without an inner corner. Throws `NoInputError` when the file is missing or not readable, `DataError`
/// for a damaged one. O(n log n); may be called from several threads.
std::optional<deformation::WitnessMesh> readCells(const std::filesystem::path& file);

} // namespace viscera::medical_io
