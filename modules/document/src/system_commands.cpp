#include "viscera/document/system_commands.h"

#include <set>
#include <utility>

#include "viscera/coordinates/cage/cage.h"
#include "viscera/core/phrase.h"
#include "viscera/document/edit.h"
#include "viscera/document/rig_commands.h"
#include "viscera/geometry/self_intersections.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/medical_io/surface_file.h"

namespace viscera::document {
namespace {

DocumentState withCage(const DocumentState& state, const GivenCage& cage, IdSource& ids) {
  coordinates::requireCage(*cage.mesh, named(cage.name));
  if (handlesAtAllVertices(*state.rig, *cage.mesh)) {
    Rig rig = *state.rig;
    rig.cage = edit::cageOf(rig, coordinates::cageOver(rig.restPositions(), *cage.mesh));
    return edit::withRig(state, std::move(rig), *state.pose);
  }
  geometry::TriangleMesh outward = *cage.mesh;
  geometry::orientOutward(outward);
  Rig rig = rigAt(outward.points);
  rig.cage = edit::cageOf(rig, outward.triangles);
  return replaceRig(std::move(rig)).apply(state, ids);
}

} // namespace

Command setSystem(SystemChoice choice) {
  return edit::onPart(phrase("Coordinates %1", choice.id), &DocumentState::system,
                      [choice](SystemChoice& system) { system = choice; });
}

Command setParameter(std::string name, double value) {
  return edit::onPart(
      phrase("Set %1", name), &DocumentState::system,
      [name, value](SystemChoice& system) { system.parameters.set(name, value); }, "parameter/" + name);
}

GivenCage readCage(const std::filesystem::path& file, Progress& progress) {
  geometry::TriangleMesh mesh = medical_io::readSurface(file).mesh;
  if (mesh.points.rows() > kMostCageVertices)
    throw DataError(phrase("It has %n {vertex|vertices}", mesh.points.rows()), file.string(),
                    phrase("a cage is a coarse surface: take one of at most %1 vertices", kMostCageVertices));
  coordinates::requireCage(mesh, file.string());
  const int crossings = geometry::countSelfIntersections(mesh, progress);
  if (crossings > 0)
    throw DataError(phrase("It crosses itself, at %n {pair|pairs} of triangles", crossings), file.string(),
                    "move the vertices there apart, or take another cage");
  geometry::orientOutward(mesh);
  return {file.filename().string(), std::make_shared<const geometry::TriangleMesh>(std::move(mesh))};
}

bool handlesAtAllVertices(const Rig& rig, const geometry::TriangleMesh& cage) {
  const std::vector<int> handles = coordinates::handlesAtVertices(rig.restPositions(), cage);
  const std::set<int> each(handles.begin(), handles.end());
  return each.size() == handles.size() && each.count(-1) == 0;
}

Command takeCage(GivenCage cage) {
  return {phrase("Take the cage %1", named(cage.name)),
          [cage](const DocumentState& state, IdSource& ids) { return withCage(state, cage, ids); }};
}

Command dropCage() {
  return edit::onPart("Use the hull as the cage", &DocumentState::rig, [](Rig& rig) { rig.cage.clear(); });
}

} // namespace viscera::document
