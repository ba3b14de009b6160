#include "handle_picture.h"

#include <algorithm>

#include "viscera/deformation/selection_motion.h"
#include "viscera/presentation/space_parts.h"
#include "viscera/scene/vtkVisceraGizmoRepresentation.h"
#include "viscera/scene/vtkVisceraGizmoWidget.h"
#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"

namespace viscera::presentation {
namespace {

/// Logical pixels: small enough that two hundred handles leave the organ to be seen.
constexpr double kRadius = 6;
constexpr double kActiveRadius = 8;
/// Handles in no group.
const Vec3 kUngrouped(0.95, 0.62, 0.20);
/// Handles that compensate are tinted so, where that matters.
const Vec3 kCompensating(0.25, 0.75, 0.85);
constexpr double kTint = 0.7;
/// The smallest number of handles that the gizmo rotates and scales.
constexpr std::size_t kFewestHandles = 2;
/// Half a side of the mirror plane, as a part of the organ's diagonal.
constexpr double kHalfSide = 0.42;

/// The selected handles' rows, ascending.
std::vector<int> selectedRows(const Scene& scene, bool onlyFree) {
  const document::Rig& rig = *scene.state.rig;
  std::vector<int> rows;
  for (const document::HandleId id : scene.view.selection.handles) {
    const int row = rig.indexOf(id);
    if (row >= 0 && !(onlyFree && rig.handles[static_cast<std::size_t>(row)].locked))
      rows.push_back(row);
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

/// The organ under the mouse; none where it has left the document, or is the only one.
document::OrganId pointedOrgan(const Scene& scene) {
  const document::OrganList& organs = *scene.state.organs;
  const bool there = std::any_of(organs.begin(), organs.end(),
                                 [&scene](const auto& organ) { return organ->id == scene.pointedOrgan; });
  return there && organs.size() > 1 ? scene.pointedOrgan : document::OrganId{};
}

} // namespace

Points handlePlaces(const document::DocumentState& state, const live::PosedOrgans& organs) {
  const Points& posed = organs.shownPose();
  return posed.rows() == static_cast<Eigen::Index>(state.rig->handles.size()) ? posed
                                                                              : state.rig->restPositions();
}

Colors handleColors(const document::Rig& rig, bool tinted) {
  Colors colors(static_cast<Eigen::Index>(rig.handles.size()), 3);
  for (std::size_t row = 0; row < rig.handles.size(); ++row) {
    const document::Group* group = rig.groupOf(rig.handles[row].id);
    Vec3 color = 255.0 * (group ? group->color : kUngrouped);
    if (tinted && rig.handles[row].compensates)
      color = (1 - kTint) * color + 255.0 * kTint * kCompensating;
    colors.row(static_cast<Eigen::Index>(row)) = color.cast<std::uint8_t>().transpose();
  }
  return colors;
}

HandlePicture::HandlePicture(scene::OrganView& view) : view_(view) {
  view.handles()->SetHandleRadius(kRadius);
  view.handles()->SetActiveRadius(kActiveRadius);
}

void HandlePicture::update(const Scene& scene, const ShownWhere& shownWhere) {
  const document::Rig& rig = *scene.state.rig;
  auto* handles = view_.handles();
  handles->SetPositions(handlePlaces(scene.state, scene.organs));
  handles->SetColors(handleColors(rig, scene.view.shown.compensating));
  const bool shown = scene.view.shown.handles || scene.view.handles;
  const document::OrganId pointed = shown ? pointedOrgan(scene) : document::OrganId{};
  for (std::size_t i = 0; i < rig.handles.size(); ++i) {
    const int row = static_cast<int>(i);
    const bool here = !shownWhere || shownWhere(handles->GetPosition(row));
    handles->SetHandleShown(row, shown && here && rig.handles[i].visible);
    handles->SetHandleInBackground(row, pointed && !owners_.isOf(scene.state, i, pointed));
    handles->SetHandleLocked(row, rig.handles[i].locked || !scene.view.shown.movable);
  }
  handles->SetSelection(selectedRows(scene, false));
  updateGizmo(scene);
  updateMirror(scene);
}

void HandlePicture::updateGizmo(const Scene& scene) {
  if (view_.gizmoWidget()->IsDragging()) // It stays where it was grabbed.
    return;
  const std::vector<int> rows = selectedRows(scene, true);
  const bool show = scene.view.gizmo && scene.view.shown.tools && rows.size() >= kFewestHandles;
  view_.gizmo()->SetVisibility(show);
  if (show)
    view_.gizmo()->SetCenter(deformation::selectionCenter(*scene.state.pose, rows));
  else
    view_.gizmo()->SetActivePart(vtkVisceraGizmoRepresentation::Nothing);
}

void HandlePicture::updateMirror(const Scene& scene) {
  const document::OrganId selected = scene.view.selection.organ;
  const auto plane = mirrorPlaneOf(scene.state, selected, scene.view.mirror);
  if (plane && scene.view.shown.tools)
    view_.mirrorPlane().show(plane->point, plane->normal,
                             kHalfSide *
                                 boundsOf(currentOrgan(scene.state, selected)->mesh->points).diagonal());
  else
    view_.mirrorPlane().hide();
}

} // namespace viscera::presentation
