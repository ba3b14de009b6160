#pragma once

#include <memory>
#include <string>
#include <vector>

#include "viscera/coordinates/coordinate_system.h"
#include "viscera/core/error.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::deformation {

/// Vertices without coordinates, and why.
class UnboundVertices final : public DataError {
public:
  /// `outsideHull` of the `vertices` lie outside the hull of all handles; `groupsCount` when it is the
  /// groups' regions that they lie outside of.
  UnboundVertices(std::vector<int> vertices, int outsideHull, bool groupsCount, const std::string& what,
                  const std::string& tryThis);

  const std::vector<int>& vertices() const { return vertices_; } ///< Rows of the organ's points, ascending.
  int outsideHull() const { return outsideHull_; }
  bool groupsCount() const { return groupsCount_; }

private:
  std::vector<int> vertices_;
  int outsideHull_;
  bool groupsCount_;
};

/// Binds an organ to handles and does not accept a partial answer. Throws what the system throws, and
/// `UnboundVertices` when vertices have no coordinates: how many, the first of them, how far out, and what
/// helps: enclosing handles, or where groups count a group around them.
std::shared_ptr<const coordinates::Binding>
bindOrgan(const coordinates::CoordinateSystem& system, const coordinates::HandleSet& handles,
          const Points& organPoints, const coordinates::BindOptions& options, Progress& progress);

} // namespace viscera::deformation
