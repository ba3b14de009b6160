#include "viscera/coordinates/cage/cage.h"

#include "viscera/coordinates/cage/given_cage.h"
#include "viscera/geometry/convex_hull.h"
#include "viscera/geometry/surface_check.h"

namespace viscera::coordinates {

Triangles cageOf(const HandleSet& handles) {
  if (handles.cage.rows() == 0)
    return geometry::ConvexHull(handles.positions).triangles();
  geometry::TriangleMesh cage{handles.positions, handles.cage, {}};
  requireCage(cage);
  geometry::orientOutward(cage);
  return cage.triangles;
}

} // namespace viscera::coordinates
