#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh_formats/cell_mesh.h"

namespace viscera::medical_io {

/// Adds a cell of an unstructured grid by VTK's number of its type. Throws `DataError` for a type that is not
/// read, such as a polyhedron, and for a cell with too few points.
void addVtkCell(CellMesh& mesh, std::int64_t type, std::span<const std::int64_t> points, std::int64_t region,
                const FileBytes& file);

/// The numbers of regions in the values of an array at the cells; none when some are no whole numbers.
std::vector<std::int64_t> wholeNumbers(const std::vector<double>& values);

} // namespace viscera::medical_io
