#pragma once

#include <memory>
#include <string>
#include <vector>

#include "viscera/coordinates/coordinate_system.h"
#include "viscera/core/error.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::deformation {

/// Thrown when vertices of an organ cannot be bound; names them and the reason.
class UnboundVertices final : public DataError {
public:
  /// What the vertices lie outside of.
  enum class Of { hull, regions, cage };

  /// `outsideHull` of the `vertices` lie outside the hull of all handles.
  UnboundVertices(std::vector<int> vertices, int outsideHull, Of of, const std::string& what,
                  const std::string& tryThis);

  const std::vector<int>& vertices() const { return vertices_; } ///< Rows of the organ's points, ascending.
  int outsideHull() const { return outsideHull_; }
  /// It is the groups' regions, or the rig's own cage, that count.
  bool groupsCount() const { return of_ == Of::regions; }
  bool cageCounts() const { return of_ == Of::cage; }

private:
  std::vector<int> vertices_;
  int outsideHull_;
  Of of_;
};

/// Binds an organ to handles, and throws when a vertex cannot be bound. Throws what the system throws, and
/// `UnboundVertices` when vertices have no coordinates: how many, the first of them, how far out, and what
/// helps: enclosing handles, where groups count a group around them, where a given cage counts another one.
std::shared_ptr<const coordinates::Binding>
bindOrgan(const coordinates::CoordinateSystem& system, const coordinates::HandleSet& handles,
          const Points& organPoints, const coordinates::BindOptions& options, Progress& progress);

} // namespace viscera::deformation
