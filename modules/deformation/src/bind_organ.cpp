#include "viscera/deformation/bind_organ.h"

#include <algorithm>
#include <sstream>

#include "viscera/core/error.h"
#include "viscera/geometry/convex_hull.h"

namespace viscera::deformation {
namespace {

[[noreturn]] void refuse(const Points& handles, const Points& organ, const std::vector<int>& failures) {
  const geometry::ConvexHull hull(handles);
  double farthest = 0;
  std::size_t outside = 0;
  for (const int vertex : failures) {
    const double distance = hull.signedDistance(organ.row(vertex).transpose());
    farthest = std::max(farthest, distance);
    outside += distance > 0;
  }
  std::ostringstream what;
  what << failures.size() << " of " << organ.rows() << " vertices have no coordinates";
  if (outside > 0)
    what << ": " << outside << " lie outside the handles' hull, by up to " << farthest << " mm";
  throw DataError(what.str(), "vertex " + std::to_string(failures.front()),
                  "add the enclosing handles, or move handles outward until they surround the organ");
}

} // namespace

std::shared_ptr<const coordinates::Binding>
bindOrgan(const coordinates::CoordinateSystem& system, const coordinates::HandleSet& handles,
          const Points& organPoints, const coordinates::BindOptions& options, Progress& progress) {
  std::shared_ptr<const coordinates::Binding> binding = system.bind(handles, organPoints, options, progress);
  if (!binding->report().failures.empty())
    refuse(handles.positions, organPoints, binding->report().failures);
  return binding;
}

} // namespace viscera::deformation
