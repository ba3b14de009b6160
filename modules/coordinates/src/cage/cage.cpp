#include "viscera/coordinates/cage/cage.h"

#include <string>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/convex_hull.h"
#include "viscera/geometry/surface_check.h"

namespace viscera::coordinates {
namespace {

/// Part of the cage's size: files keep six digits of a position.
constexpr double kSameCornerPlace = 1e-6;

} // namespace

Triangles cageOf(const HandleSet& handles) {
  if (handles.cage.rows() == 0)
    return geometry::ConvexHull(handles.positions).triangles();
  geometry::TriangleMesh cage{handles.positions, handles.cage, {}};
  requireCage(cage);
  geometry::orientOutward(cage);
  return cage.triangles;
}

void requireCage(const geometry::TriangleMesh& cage, const Text& where) {
  constexpr const char* kTryThis =
      "take a closed cage, or none: then the convex hull of the handles is the cage";
  geometry::requireValid(cage, where);
  if (cage.triangles.rows() == 0)
    throw DataError("It has no triangles", where, kTryThis);
  const auto report = geometry::checkSurface(cage);
  if (report.boundaryEdges > 0)
    throw DataError(phrase("is open at %n {edge|edges}", report.boundaryEdges), where, kTryThis);
  if (const int edges = report.nonManifoldEdges + report.misorientedEdges; edges > 0)
    throw DataError(phrase("is not manifold at %n {edge|edges}", edges), where, kTryThis);
}

std::vector<int> handlesAtVertices(const Points& handles, const geometry::TriangleMesh& cage) {
  std::vector<int> found(static_cast<std::size_t>(cage.points.rows()), -1);
  if (handles.rows() == 0)
    return found;
  const double tolerance = kSameCornerPlace * boundsOf(cage.points).diagonal();
  for (std::size_t vertex = 0; vertex < found.size(); ++vertex) {
    Eigen::Index nearest = 0;
    const auto place = cage.points.row(static_cast<Eigen::Index>(vertex));
    const double squared = (handles.rowwise() - place).rowwise().squaredNorm().minCoeff(&nearest);
    if (squared <= tolerance * tolerance)
      found[vertex] = static_cast<int>(nearest);
  }
  return found;
}

Triangles cageOver(const Points& handles, const geometry::TriangleMesh& cage) {
  requireCage(cage);
  geometry::TriangleMesh outward = cage;
  geometry::orientOutward(outward);
  const std::vector<int> names = handlesAtVertices(handles, cage);
  for (std::int32_t& corner : outward.triangles.reshaped<Eigen::RowMajor>()) {
    const int name = names[static_cast<std::size_t>(corner)];
    if (name < 0)
      throw DataError(phrase("there is no handle at vertex %1", corner), "the cage",
                      "make the handles from this cage: viscera handles ORGAN --cage FILE");
    corner = name;
  }
  return outward.triangles;
}

} // namespace viscera::coordinates
