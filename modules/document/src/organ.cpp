#include "viscera/document/organ.h"

#include <iterator>
#include <utility>

#include "viscera/anatomy/organ_facts.h"
#include "viscera/anatomy/part.h"
#include "viscera/core/error.h"

namespace viscera::document {
namespace {

constexpr const char* kMobilityNames[] = {"bends", "rigid", "fixed"};

/// Whether every vertex has the colour of the first; not of a surface without colours.
bool isPaintedAlike(const geometry::TriangleMesh& mesh) {
  for (Eigen::Index vertex = 1; vertex < mesh.colors.rows(); ++vertex)
    if (mesh.colors.row(vertex) != mesh.colors.row(0))
      return false;
  return mesh.colors.rows() > 0;
}

void requireTriangles(const geometry::TriangleMesh& mesh, const std::string& name) {
  geometry::requireValid(mesh, named(name));
  if (mesh.triangles.rows() == 0)
    throw DataError("The surface has no triangle", named(name), "choose a file with a triangle surface");
}

} // namespace

bool isPure(const Vec3& color) {
  constexpr double kRounding = 1e-9;
  return color.maxCoeff() - color.minCoeff() > kMostVivid + kRounding;
}

std::string nameOf(Mobility mobility) {
  return kMobilityNames[static_cast<std::size_t>(mobility)];
}

Mobility usualMobility(const std::string& name) {
  return anatomy::isBoneNamed(name) ? Mobility::rigid : Mobility::bends;
}

std::optional<Mobility> mobilityFromName(const std::string& name) {
  for (std::size_t i = 0; i < std::size(kMobilityNames); ++i)
    if (name == kMobilityNames[i])
      return static_cast<Mobility>(i);
  return std::nullopt;
}

Organ makeOrgan(std::string name, geometry::TriangleMesh mesh) {
  return makeOrgan(std::move(name), std::make_shared<const geometry::TriangleMesh>(std::move(mesh)));
}

Organ makeOrgan(std::string name, std::shared_ptr<const geometry::TriangleMesh> mesh) {
  requireTriangles(*mesh, name);
  const geometry::SurfaceReport report = geometry::checkSurface(*mesh);
  return makeOrgan(std::move(name), std::move(mesh), report);
}

Organ makeOrgan(std::string name, std::shared_ptr<const geometry::TriangleMesh> mesh,
                geometry::SurfaceReport report) {
  requireTriangles(*mesh, name);
  Organ organ;
  organ.warnings = geometry::faults(report);
  if (report.closed() && report.volumeMm3 < 0) {
    geometry::TriangleMesh turned = *mesh;
    geometry::orientOutward(turned);
    mesh = std::make_shared<const geometry::TriangleMesh>(std::move(turned));
    report.volumeMm3 = -report.volumeMm3;
    organ.warnings.push_back("its triangles were turned around to face outward");
  }
  organ.name = std::move(name);
  organ.mesh = std::move(mesh);
  if (organ.mesh->colors.rows() > 0) // The colour of a painted surface in lists and charts.
    organ.look.color = organ.mesh->colors.cast<double>().colwise().mean().transpose() / 255.0;
  organ.look.vertexColors = !isPaintedAlike(*organ.mesh);
  const bool plain = organ.mesh->colors.rows() == 0;
  const bool numbered = !organ.look.vertexColors && isPure(organ.look.color);
  if (plain || numbered)
    organ.look.color = anatomy::colorNamed(organ.name).value_or(organ.look.color);
  organ.boundaryEdges = report.boundaryEdges;
  organ.restVolumeMm3 = report.closed() ? report.volumeMm3 : 0;
  organ.mobility = usualMobility(organ.name);
  return organ;
}

} // namespace viscera::document
