#pragma once

#include <memory>
#include <string>
#include <vector>

#include "viscera/coordinates/coordinate_system.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::deformation {

/// Thrown when vertices of an organ cannot be bound; names them and the reason.
class UnboundVertices final : public DataError {
public:
  /// The region outside of which the vertices lie.
  enum class Of { hull, regions, cage };

  /// `outsideHull` of the `vertices` lie outside the hull of all handles.
  UnboundVertices(std::vector<int> vertices, int outsideHull, Of of, const Text& what, const Text& tryThis);

  const std::vector<int>& vertices() const { return vertices_; } ///< Rows of the organ's points, ascending.
  int outsideHull() const { return outsideHull_; }
  /// Whether the groups' regions, or the rig's own cage, determine which points can be bound.
  bool groupsCount() const { return of_ == Of::regions; }
  bool cageCounts() const { return of_ == Of::cage; }

private:
  std::vector<int> vertices_;
  int outsideHull_;
  Of of_;
};

/// Binds an organ to handles, and throws when a vertex cannot be bound. Throws what the system throws, and
/// `UnboundVertices` when vertices have no coordinates: how many, the first of them, how far out, and the
/// remedy: enclosing handles, for grouped handles a group around them, for a given cage another one.
std::shared_ptr<const coordinates::Binding>
bindOrgan(const coordinates::CoordinateSystem& system, const coordinates::HandleSet& handles,
          const Points& organPoints, const coordinates::BindOptions& options, Progress& progress);

} // namespace viscera::deformation
