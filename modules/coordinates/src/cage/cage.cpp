#include "cage/cage.h"

#include <string>

#include "viscera/core/error.h"
#include "viscera/geometry/convex_hull.h"
#include "viscera/geometry/surface_check.h"

namespace viscera::coordinates {

Triangles cageOf(const HandleSet& handles) {
  if (handles.cage.rows() == 0)
    return geometry::ConvexHull(handles.positions).triangles();
  geometry::TriangleMesh cage{handles.positions, handles.cage, {}};
  geometry::requireValid(cage, "the cage");
  const auto report = geometry::checkSurface(cage);
  const auto refuse = [](int edges, const std::string& problem) {
    if (edges > 0)
      throw DataError(problem + " at " + std::to_string(edges) + " edges", "the cage",
                      "take a closed cage, or none: then the convex hull of the handles is the cage");
  };
  refuse(report.boundaryEdges, "is open");
  refuse(report.nonManifoldEdges + report.misorientedEdges, "is not manifold");
  geometry::orientOutward(cage);
  return cage.triangles;
}

} // namespace viscera::coordinates
