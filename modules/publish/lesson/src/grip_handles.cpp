#include "grip_handles.h"

#include <algorithm>

#include "viscera/coordinates/systems.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/deformation/place_handles.h"

namespace viscera::lesson {
namespace {

constexpr int kCorners = 8;
constexpr int kVerticesAHandle = 2; ///< A surface of few vertices has no room for more.

/// The surfaces of a lesson that are no cavities, as one.
geometry::TriangleMesh outside(const Lesson& lesson, const document::DocumentState& state) {
  geometry::TriangleMesh mesh;
  for (std::size_t i = 0; i < lesson.surfaces.size(); ++i) {
    const LessonSurface& surface = lesson.surfaces[i];
    const document::OrganId parent = state.organ(lesson.plan.surfaces[i].organ)->parent;
    if (i > 0 && parent != document::OrganId{} && state.organ(parent))
      continue;
    const Eigen::Index before = mesh.points.rows(), triangles = mesh.triangles.rows();
    mesh.points.conservativeResize(before + surface.vertexCount, 3);
    mesh.points.bottomRows(surface.vertexCount) =
        lesson.rest.middleRows(surface.firstVertex, surface.vertexCount);
    mesh.triangles.conservativeResize(triangles + surface.triangleCount, 3);
    mesh.triangles.bottomRows(surface.triangleCount) =
        lesson.triangles.middleRows(surface.firstTriangle, surface.triangleCount).array() +
        static_cast<std::int32_t>(before - surface.firstVertex);
  }
  return mesh;
}

} // namespace

GripHandles gripHandles(const Lesson& lesson, const document::DocumentState& state, int count,
                        Progress& progress, Threads threads) {
  const geometry::TriangleMesh organs = outside(lesson, state);
  count = std::min(count, static_cast<int>(organs.points.rows() / kVerticesAHandle));
  deformation::Placement placement;
  placement.count = count + kCorners;
  coordinates::HandleSet handles;
  handles.positions = deformation::placeHandles(organs, placement);
  const Points vertices = lesson.rest.topRows(lesson.vertexCount());
  const std::string wanted = document::SystemChoice().id;
  for (const auto& system : coordinates::builtInSystems()) {
    if (system->id() != wanted)
      continue;
    const auto binding = deformation::bindOrgan(*system, handles, vertices, {{}, threads}, progress);
    GripHandles grips{handles.positions.bottomRows(count), Table(count, vertices.rows())};
    for (int i = 0; i < count; ++i)
      grips.weights.row(i) = binding->influence(kCorners + i).transpose();
    return grips;
  }
  return {};
}

} // namespace viscera::lesson
