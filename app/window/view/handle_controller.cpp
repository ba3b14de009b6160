#include "window/view/handle_controller.h"

#include <algorithm>
#include <utility>

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include "viscera/document/rig_commands.h"
#include "viscera/scene/vtkVisceraGizmoRepresentation.h"
#include "viscera/scene/vtkVisceraGizmoWidget.h"
#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"
#include "viscera/scene/vtkVisceraHandleSetWidget.h"
#include "window/style/language.h"

namespace viscera::app {

HandleController::HandleController(Workspace& workspace, PoseEditor& poses, const ViewModel& model,
                                   Picture& picture, QObject* parent)
    : QObject(parent), workspace_(workspace), poses_(poses), model_(model), picture_(picture),
      view_(picture.view()) {
  listenToHandles();
  listenToGizmo();
  connect(&poses, &PoseEditor::gestureChanged, this, &HandleController::showConstraint);
  // Cancel the drag, for example after a change of the mode.
  connect(&model, &ViewModel::changed, this, [this] {
    if (dragging() && !(shown() == grabbed_))
      cancelDrag();
  });
}

HandleController::~HandleController() {
  for (const unsigned long tag : handleObservers_)
    view_.handleWidget()->RemoveObserver(tag);
  for (const unsigned long tag : gizmoObservers_)
    view_.gizmoWidget()->RemoveObserver(tag);
}

void HandleController::listenToHandles() {
  using Widget = vtkVisceraHandleSetWidget;
  const auto listen = [this](unsigned long event, std::function<void(const scene::HandleEvent&)> listener) {
    handleObservers_.push_back(scene::observe(view_.handleWidget(), event, std::move(listener)));
  };
  listen(Widget::HandleHoveredEvent, [this](const auto&) { picture_.markOutdated(); });
  listen(Widget::HandleGrabbedEvent, [this](const auto& event) { onGrabbed(event); });
  listen(Widget::HandleMovedEvent, [this](const auto& event) { onMoved(event); });
  listen(Widget::HandleReleasedEvent, [this](const auto&) { onReleased(); });
  listen(Widget::HandleCancelledEvent, [this](const auto&) { onCancelled(); });
  listen(Widget::SelectionChangedEvent, [this](const auto& event) { onSelected(event); });
}

void HandleController::listenToGizmo() {
  using Widget = vtkVisceraGizmoWidget;
  const auto listen = [this](unsigned long event, std::function<void(const scene::GizmoEvent&)> listener) {
    gizmoObservers_.push_back(scene::observe(view_.gizmoWidget(), event, std::move(listener)));
  };
  listen(Widget::HoveredEvent, [this](const auto&) { picture_.markOutdated(); });
  listen(Widget::GrabbedEvent, [this](const auto& event) { onGizmoGrabbed(event); });
  listen(Widget::MovedEvent, [this](const auto& event) { onGizmoMoved(event); });
  listen(Widget::ReleasedEvent, [this](const auto&) {
    poses_.finish();
    picture_.markOutdated();
  });
  listen(Widget::CancelledEvent, [this](const auto&) {
    poses_.cancel();
    picture_.markOutdated();
  });
}

bool HandleController::underMouse() const {
  const scene::OrganView& view = picture_.view();
  const bool onGizmo = view.gizmo()->GetVisibility() != 0 &&
                       view.gizmo()->GetActivePart() != vtkVisceraGizmoRepresentation::Nothing;
  return dragging() || onGizmo || view.handles()->GetActiveHandle() >= 0;
}

bool HandleController::dragging() const {
  return view_.handleWidget()->IsDragging() || view_.gizmoWidget()->IsDragging();
}

bool HandleController::cancelDrag() {
  if (!dragging())
    return false;
  const scene::OrganView& view = picture_.view();
  view.handleWidget()->CancelDrag();
  view.gizmoWidget()->CancelDrag();
  return true;
}

std::vector<document::HandleId> HandleController::idsOf(const std::vector<int>& rows) const {
  std::vector<document::HandleId> ids;
  for (const int row : rows)
    ids.push_back(workspace_.document().rig().handles.at(static_cast<std::size_t>(row)).id);
  return ids;
}

void HandleController::onSelected(const scene::HandleEvent& event) {
  std::vector<document::HandleId> ids = idsOf(view_.handles()->GetSelection());
  // The clicked handle goes last: the last one is the current one.
  if (event.handle >= 0) {
    const document::HandleId clicked = idsOf({event.handle}).front();
    if (std::erase(ids, clicked) > 0)
      ids.push_back(clicked);
  }
  workspace_.selection().setHandles(ids);
}

void HandleController::onGrabbed(const scene::HandleEvent& event) {
  grabbed_ = shown();
  if (!grabbed_.movable || event.handle < 0)
    return;
  dragFailed_ = false;
  const auto& handles = workspace_.document().rig().handles;
  const QString name =
      event.moving.size() > 1
          ? tr("Move %n handles", nullptr, static_cast<int>(event.moving.size()))
          : tr("Move handle %1").arg(inWords(handles.at(static_cast<std::size_t>(event.handle)).label));
  if (grabbed_.rest) {
    workspace_.guarded([&] { step_.emplace(workspace_.undo(), name.toStdString()); });
  } else {
    poses_.begin(name, idsOf(event.moving), true, event.plane ? event.plane : planeOfView());
  }
}

/// The plane in which the cursor moves a handle. A handle that a locked volume holds back stays in it: it
/// never goes towards the viewer, of which the screen shows nothing.
std::optional<Vec3> HandleController::planeOfView() const {
  const auto organs = workspace_.document().organs();
  if (std::none_of(organs.begin(), organs.end(), [](const auto& organ) { return organ->volumeLocked; }))
    return std::nullopt;
  Vec3 sight;
  view_.renderer()->GetActiveCamera()->GetDirectionOfProjection(sight.data());
  return sight;
}

void HandleController::onMoved(const scene::HandleEvent& event) {
  if (!grabbed_.movable)
    return;
  if (grabbed_.rest)
    return moveAtRest(event.moving);
  poses_.translate(event.delta());
  // Draws the actual positions of the handles, which may differ from the cursor's, and of others that moved
  // along.
  picture_.markOutdated();
}

void HandleController::moveAtRest(const std::vector<int>& rows) {
  if (!step_)
    return;
  Points positions(static_cast<Eigen::Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i)
    positions.row(static_cast<Eigen::Index>(i)) = view_.handles()->GetPosition(rows[i]).transpose();
  try {
    workspace_.undo().perform(document::moveRestHandles(idsOf(rows), std::move(positions)));
  } catch (const Error& error) {
    if (!dragFailed_)
      workspace_.report(error);
    dragFailed_ = true;
  }
}

void HandleController::onReleased() {
  if (auto step = std::exchange(step_, std::nullopt))
    workspace_.guarded([&] { step->finish(); });
  else
    poses_.finish();
  picture_.markOutdated();
}

void HandleController::onCancelled() {
  if (auto step = std::exchange(step_, std::nullopt))
    workspace_.guarded([&] { step->cancel(); });
  else
    poses_.cancel();
  picture_.markOutdated();
}

void HandleController::onGizmoGrabbed(const scene::GizmoEvent& event) {
  grabbed_ = shown();
  const document::Rig& rig = workspace_.document().rig();
  std::vector<document::HandleId> ids;
  for (const document::HandleId id : workspace_.selection().handles())
    if (const int row = rig.indexOf(id); row >= 0 && !rig.handles[static_cast<std::size_t>(row)].locked)
      ids.push_back(id);
  const int count = static_cast<int>(ids.size());
  poses_.begin(event.rotates ? tr("Turn %n handles", nullptr, count) : tr("Scale %n handles", nullptr, count),
               ids, false);
}

void HandleController::onGizmoMoved(const scene::GizmoEvent& event) {
  if (event.rotates)
    poses_.rotate(event.center, event.axis, event.angle);
  else
    poses_.scale(event.center, event.factors);
  picture_.markOutdated();
}

/// The plane in which the held handle may go while the volume is locked, and the way in which it would grow.
void HandleController::showConstraint() {
  const live::LockedMotion* motion = poses_.motion();
  const int held = view_.handles()->GetActiveHandle();
  const Vec3 normal = motion ? motion->planeNormal() : Vec3(Vec3::Zero());
  if (held >= 0 && normal.norm() > 0 && held < motion->pose().rows())
    view_.constraint().show(motion->pose().row(held).transpose(), normal);
  else
    view_.constraint().hide();
  picture_.markOutdated();
}

} // namespace viscera::app
