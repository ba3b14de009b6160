#include "viscera/deformation/bind_organ.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/deformation/tetrahedralise.h"
#include "viscera/geometry/convex_hull.h"

namespace viscera::deformation {
namespace {

[[noreturn]] void refuse(const coordinates::HandleSet& handles, bool groupsCount, const Points& organ,
                         const std::vector<int>& failures) {
  const geometry::ConvexHull hull(handles.positions);
  double farthest = 0;
  int outside = 0;
  for (const int vertex : failures) {
    const double distance = hull.signedDistance(organ.row(vertex).transpose());
    farthest = std::max(farthest, distance);
    outside += distance > 0;
  }
  std::ostringstream what;
  what << failures.size() << " of " << organ.rows() << " vertices ";
  if (groupsCount)
    what << "lie in no group's region";
  else
    what << "have no coordinates";
  if (outside > 0)
    what << ": " << outside << " lie outside the handles' hull, by up to " << farthest << " mm";
  throw UnboundVertices(failures, outside, groupsCount, what.str(),
                        groupsCount
                            ? "add a group that encloses them, or put handles around them into a group"
                            : "add the enclosing handles, or move handles outward until they surround "
                              "the organ");
}

} // namespace

UnboundVertices::UnboundVertices(std::vector<int> vertices, int outsideHull, bool groupsCount,
                                 const std::string& what, const std::string& tryThis)
    : DataError(what, vertices.empty() ? std::string() : "vertex " + std::to_string(vertices.front()),
                tryThis),
      vertices_(std::move(vertices)), outsideHull_(outsideHull), groupsCount_(groupsCount) {}

std::shared_ptr<const coordinates::Binding>
bindOrgan(const coordinates::CoordinateSystem& system, const coordinates::HandleSet& handles,
          const Points& organPoints, const coordinates::BindOptions& options, Progress& progress) {
  std::shared_ptr<const coordinates::Binding> binding =
      system.bind(handles, organPoints, withTetgen(options), progress);
  if (!binding->report().failures.empty())
    refuse(handles, system.traits().usesGroups && !handles.groups.empty(), organPoints,
           binding->report().failures);
  return binding;
}

} // namespace viscera::deformation
