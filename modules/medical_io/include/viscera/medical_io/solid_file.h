#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/deformation/witness_mesh.h"

namespace viscera::medical_io {

/// A named array of numbers or vectors at the points of a tetrahedral mesh, as ParaView shows it.
struct SolidArray {
  std::string name;
  std::variant<Values, Points, std::vector<std::uint8_t>> values; ///< One, three, or one (yes or no) a point.
};

/// Writes tetrahedra as VTK's XML unstructured grid (.vtu, binary): `points` is `n x 3` mm LPS, `arrays` have
/// n rows each; the first is the one that is active. Points of no tetrahedron become vertices, so that they
/// are seen as well. First to a temporary name, then renamed. Throws `CannotCreateError` when the file cannot
/// be written or does not end in .vtu, `DataError` for an array of another size. O(n + t).
void writeSolid(const std::filesystem::path& file, const Points& points,
                const deformation::Tetrahedra& tetrahedra, const std::vector<SolidArray>& arrays);

} // namespace viscera::medical_io
