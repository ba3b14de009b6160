#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "viscera/core/progress.h"
#include "viscera/deformation/tetrahedralise.h"
#include "viscera/deformation/witness_mesh.h"
#include "viscera/geometry/triangle_mesh.h"

/// The wall of an organ as tetrahedra, for finite elements.
namespace viscera::deformation {

/// A closed surface that bounds the tissue of an organ: its outer surface, or that of a cavity.
struct NamedWall {
  std::string name;
  std::shared_ptr<const geometry::TriangleMesh> mesh; ///< mm, LPS; of either orientation.
};

/// Tetrahedra that fill an organ up to its cavities.
struct OrganSolid {
  /// A wall of the solid, with the name of its surface.
  struct Wall {
    std::string name;
    std::vector<std::int32_t> nodes; ///< Points on it, ascending.
    /// The faces of tetrahedra on it: the tetrahedron, and the corner (0 to 3) that is not on the face.
    std::vector<std::array<std::int32_t, 2>> faces;
  };

  Points points;         ///< `n x 3`, mm, LPS.
  Tetrahedra tetrahedra; ///< `t x 4`, positive.
  /// The outer wall first, then the cavities in their order. Every point on the boundary is on one wall, and
  /// so is every face.
  std::vector<Wall> walls;
};

/// Fills an organ with tetrahedra by TetGen, and leaves its cavities empty. The vertices and triangles of all
/// surfaces are those of the walls, bit for bit. The surfaces may not touch or cross each other, and every
/// cavity lies inside. Throws what `tetrahedralise` throws, and `TetrahedraError` also for surfaces that
/// share a point, for a cavity that is open, and for one that is not wholly inside. O(n log n) beside
/// TetGen's time; from any thread.
OrganSolid fillOrgan(const NamedWall& outer, const std::vector<NamedWall>& cavities,
                     const TetrahedraOptions& options, Progress& progress);

} // namespace viscera::deformation
