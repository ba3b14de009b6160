#pragma once

#include <memory>
#include <vector>

#include "viscera/geometry/triangle_mesh.h"

namespace viscera::live {

/// The blood of one side of a heart, from the ends of its veins through the chambers to those of its
/// arteries, as one closed surface that lies on the inside of the walls and ends flat, within a triangle's
/// edge of where the vessels do. Immutable; thread-safe.
class HeartBlood {
public:
  /// `lumen` is the closed surface from which the inside of `walls` was made, whose vertices so are among
  /// those of the walls: all but those beyond the vessels' ends. O(n log n).
  HeartBlood(const geometry::TriangleMesh& lumen, const geometry::TriangleMesh& walls);

  const std::shared_ptr<const geometry::TriangleMesh>& mesh() const { return mesh_; } ///< At rest.
  /// How many ends it has.
  std::size_t ends() const { return rims_.size(); }
  /// Writes its points for the walls' vertices as they are now. O(n).
  void at(const Points& walls, Points& out) const;

private:
  std::shared_ptr<const geometry::TriangleMesh> mesh_;
  std::vector<Eigen::Index> wall_; ///< The walls' vertex of each point but the last ones: the ends' middles.
  std::vector<std::vector<Eigen::Index>> rims_; ///< The points around each end.
};

} // namespace viscera::live
