#include "viscera/session/organ.h"

#include <sstream>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/geometry/surface_check.h"

namespace viscera::session {
namespace {

/// Smaller than a lens of the eye, or larger than a tall patient: probably another unit.
constexpr double kSmallestPlausibleMm = 8;
constexpr double kLargestPlausibleMm = 2200;

std::string sizeWarning(const Points& points) {
  const double size = boundsOf(points).diagonal();
  if (size >= kSmallestPlausibleMm && size <= kLargestPlausibleMm)
    return {};
  std::ostringstream text;
  text << "its diagonal measures " << size << " mm, which is implausible for an organ: is the file in "
       << (size < kSmallestPlausibleMm ? "metres, centimetres or inches" : "micrometres") << "?";
  return text.str();
}

} // namespace

Organ makeOrgan(std::string name, geometry::TriangleMesh mesh) {
  return makeOrgan(std::move(name), std::make_shared<const geometry::TriangleMesh>(std::move(mesh)));
}

Organ makeOrgan(std::string name, std::shared_ptr<const geometry::TriangleMesh> mesh) {
  geometry::requireValid(*mesh, name);
  if (mesh->triangles.rows() == 0)
    throw DataError("The surface has no triangle", name, "choose a file with a triangle surface");
  Organ organ;
  geometry::SurfaceReport report = geometry::checkSurface(*mesh);
  if (report.closed() && report.volumeMm3 < 0) {
    geometry::TriangleMesh turned = *mesh;
    geometry::orientOutward(turned);
    mesh = std::make_shared<const geometry::TriangleMesh>(std::move(turned));
    report.volumeMm3 = -report.volumeMm3;
    organ.warnings.push_back("the surface was inside out; its triangles were turned around");
  }
  for (std::string& fault : geometry::faults(report))
    organ.warnings.push_back(std::move(fault));
  if (std::string warning = sizeWarning(mesh->points); !warning.empty())
    organ.warnings.push_back(std::move(warning));
  organ.name = std::move(name);
  organ.mesh = std::move(mesh);
  organ.boundaryEdges = report.boundaryEdges;
  organ.restVolumeMm3 = report.closed() ? report.volumeMm3 : 0;
  return organ;
}

} // namespace viscera::session
