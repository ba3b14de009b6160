#include "viscera/coordinates/cage/given_cage.h"

#include <string>

#include "viscera/core/error.h"
#include "viscera/geometry/surface_check.h"

namespace viscera::coordinates {
namespace {

/// Of the cage's size: files keep six digits of a position.
constexpr double kSamePlace = 1e-6;

} // namespace

void requireCage(const geometry::TriangleMesh& cage) {
  geometry::requireValid(cage, "the cage");
  const auto report = geometry::checkSurface(cage);
  const auto refuse = [](int edges, const std::string& problem) {
    if (edges > 0)
      throw DataError(problem + " at " + std::to_string(edges) + " edges", "the cage",
                      "take a closed cage, or none: then the convex hull of the handles is the cage");
  };
  refuse(report.boundaryEdges, "is open");
  refuse(report.nonManifoldEdges + report.misorientedEdges, "is not manifold");
}

Triangles cageOver(const Points& handles, const geometry::TriangleMesh& cage) {
  requireCage(cage);
  geometry::TriangleMesh outward = cage;
  geometry::orientOutward(outward);
  const double tolerance = kSamePlace * boundsOf(cage.points).diagonal();
  std::vector<std::int32_t> names(static_cast<std::size_t>(cage.points.rows()), -1);
  for (std::int32_t& corner : outward.triangles.reshaped<Eigen::RowMajor>()) {
    std::int32_t& name = names[static_cast<std::size_t>(corner)];
    if (name < 0) {
      Eigen::Index nearest = 0;
      const double distance =
          handles.rows() == 0
              ? tolerance + 1
              : (handles.rowwise() - cage.points.row(corner)).rowwise().norm().minCoeff(&nearest);
      if (!(distance <= tolerance))
        throw DataError("there is no handle at vertex " + std::to_string(corner), "the cage",
                        "make the handles from this cage: viscera handles ORGAN --cage FILE");
      name = static_cast<std::int32_t>(nearest);
    }
    corner = name;
  }
  return outward.triangles;
}

} // namespace viscera::coordinates
