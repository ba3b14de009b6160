#include "viscera/document/system_commands.h"

#include <set>
#include <utility>

#include "viscera/coordinates/cage/cage.h"
#include "viscera/document/edit.h"
#include "viscera/document/rig_commands.h"
#include "viscera/geometry/self_intersections.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/medical_io/surface_file.h"

namespace viscera::document {
namespace {

DocumentState withCage(const DocumentState& state, const GivenCage& cage, IdSource& ids) {
  coordinates::requireCage(*cage.mesh, cage.name);
  if (standAt(*state.rig, *cage.mesh)) {
    Rig rig = *state.rig;
    rig.cage = edit::cageOf(rig, coordinates::cageOver(rig.restPositions(), *cage.mesh));
    return edit::withRig(state, std::move(rig), *state.pose);
  }
  geometry::TriangleMesh outward = *cage.mesh;
  geometry::orientOutward(outward);
  return replaceRig({newHandles(outward.points), {}, outward.triangles}).apply(state, ids);
}

} // namespace

Command setSystem(SystemChoice choice) {
  return edit::onPart("Coordinates " + choice.id, &DocumentState::system,
                      [choice](SystemChoice& system) { system = choice; });
}

Command setParameter(std::string name, double value) {
  return edit::onPart(
      "Set " + name, &DocumentState::system,
      [name, value](SystemChoice& system) { system.parameters.set(name, value); }, "parameter/" + name);
}

GivenCage readCage(const std::filesystem::path& file, Progress& progress) {
  geometry::TriangleMesh mesh = medical_io::readSurface(file).mesh;
  if (mesh.points.rows() > kMostCageVertices)
    throw DataError("It has " + std::to_string(mesh.points.rows()) + " vertices", file.string(),
                    "a cage is a coarse surface: take one of at most " + std::to_string(kMostCageVertices));
  coordinates::requireCage(mesh, file.string());
  const int crossings = geometry::countSelfIntersections(mesh, progress);
  if (crossings > 0)
    throw DataError("It crosses itself, at " + std::to_string(crossings) + " pairs of triangles",
                    file.string(), "move the vertices there apart, or take another cage");
  geometry::orientOutward(mesh);
  return {file.filename().string(), std::make_shared<const geometry::TriangleMesh>(std::move(mesh))};
}

bool standAt(const Rig& rig, const geometry::TriangleMesh& cage) {
  const std::vector<int> handles = coordinates::handlesAtVertices(rig.restPositions(), cage);
  const std::set<int> each(handles.begin(), handles.end());
  return each.size() == handles.size() && each.count(-1) == 0;
}

Command takeCage(GivenCage cage) {
  return {"Take the cage " + cage.name,
          [cage](const DocumentState& state, IdSource& ids) { return withCage(state, cage, ids); }};
}

Command dropCage() {
  return edit::onPart("Use the hull as the cage", &DocumentState::rig, [](Rig& rig) { rig.cage.clear(); });
}

} // namespace viscera::document
