#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "viscera/geometry/triangle_mesh.h"

namespace viscera::medical_io {

/// One of several surfaces in a file.
struct NamedSurface {
  std::shared_ptr<const geometry::TriangleMesh> mesh; ///< LPS mm.
  std::string name;
  Vec3 color = {0.8, 0.8, 0.8}; ///< Red green blue, 0 to 1; of a mesh without colours of its own.
  double opacity = 1;           ///< 0 to 1; as `color`.
};

/// Writes several surfaces into one GLB, each a node with its name and colour, LPS mm as `writeSurface` has
/// it. Atomic. Throws `CannotCreateError` when the file cannot be written or does not end in .glb,
/// `DataError` for no surface, or one that is not valid.
void writeSurfaces(const std::filesystem::path& file, const std::vector<NamedSurface>& surfaces);

} // namespace viscera::medical_io
