#include "viscera/deformation/bind_organ.h"

#include <algorithm>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"
#include "viscera/deformation/tetrahedralise.h"
#include "viscera/geometry/convex_hull.h"

namespace viscera::deformation {
namespace {

using Of = UnboundVertices::Of;

const char* adviceFor(Of of) {
  switch (of) {
  case Of::regions:
    return "add a group that encloses them, or put handles around them into a group";
  case Of::cage:
    return "take a cage that surrounds the organ, or the handles' convex hull as the cage";
  case Of::hull:
    break;
  }
  return "add the enclosing handles, or move handles outward until they surround the organ";
}

[[noreturn]] void refuse(const coordinates::HandleSet& handles, Of of, const Points& organ,
                         const std::vector<int>& failures) {
  const geometry::ConvexHull hull(handles.positions);
  double farthest = 0;
  int outside = 0;
  for (const int vertex : failures) {
    const double distance = hull.signedDistance(organ.row(vertex).transpose());
    farthest = std::max(farthest, distance);
    outside += distance > 0;
  }
  const std::size_t count = failures.size();
  Text what = phrase("%1 of %2 vertices have no coordinates", count, organ.rows());
  if (of == Of::regions)
    what = phrase("%1 of %2 vertices lie in no group's region", count, organ.rows());
  if (of == Of::cage)
    what = phrase("%1 of %2 vertices have no coordinates in the cage", count, organ.rows());
  if (outside > 0)
    what =
        phrase("%1: %2 lie outside the handles' hull, by up to %3 mm", what, outside, inDigits(farthest, 6));
  throw UnboundVertices(failures, outside, of, what, adviceFor(of));
}

} // namespace

UnboundVertices::UnboundVertices(std::vector<int> vertices, int outsideHull, Of of, const Text& what,
                                 const Text& tryThis)
    : DataError(what, vertices.empty() ? Text() : phrase("vertex %1", vertices.front()), tryThis),
      vertices_(std::move(vertices)), outsideHull_(outsideHull), of_(of) {}

std::shared_ptr<const coordinates::Binding>
bindOrgan(const coordinates::CoordinateSystem& system, const coordinates::HandleSet& handles,
          const Points& organPoints, const coordinates::BindOptions& options, Progress& progress) {
  std::shared_ptr<const coordinates::Binding> binding =
      system.bind(handles, organPoints, withTetgen(options), progress);
  if (binding->report().failures.empty())
    return binding;
  const coordinates::Traits traits = system.traits();
  const Of of = traits.usesGroups && !handles.groups.empty()  ? Of::regions
                : traits.needsCage && handles.cage.rows() > 0 ? Of::cage
                                                              : Of::hull;
  refuse(handles, of, organPoints, binding->report().failures);
}

} // namespace viscera::deformation
