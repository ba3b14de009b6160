#include "tetrahedra/filled_domain.h"

#include "choice_parameter.h"
#include "viscera/core/error.h"
#include "viscera/geometry/split_edges.h"

namespace viscera::coordinates {
namespace {

constexpr int kMostTriangles = 200'000;
/// Volume of a tetrahedron with edges of length 1, as a quality mesh has them on the average.
constexpr double kVolumeOfUnitEdges = 0.125;

} // namespace

FilledDomain filledDomain(const geometry::TriangleMesh& surface, const Points& inside, double resolution,
                          const std::string& system, const BindOptions& options, Progress& progress) {
  if (!options.tetrahedralise)
    throw UsageError(system + " need tetrahedra, and nobody here makes them", {},
                     "bind by way of the deformation module, or choose another system");
  const double edge = boundsOf(surface.points).diagonal() / resolution;
  geometry::TriangleMesh cut = geometry::splitLongEdges(surface, edge, kMostTriangles);
  FilledDomain domain{cut.points.rows(), {}};
  cut.points.conservativeResize(domain.onSurface + inside.rows(), 3);
  cut.points.bottomRows(inside.rows()) = inside;
  progress.report(0, "filling the handles with tetrahedra");
  domain.solid = options.tetrahedralise(cut, kVolumeOfUnitEdges * edge * edge * edge, progress);
  return domain;
}

Parameter resolutionParameter(double maximum, double standard) {
  return countParameter("resolution", "Edges of tetrahedra across the handles; more are finer and slower", 4,
                        maximum, standard);
}

} // namespace viscera::coordinates
