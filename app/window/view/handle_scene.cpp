#include "window/view/handle_scene.h"

#include <QScopedValueRollback>

#include "viscera/document/rig_commands.h"
#include "viscera/scene/handle_event.h"
#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"
#include "viscera/scene/vtkVisceraHandleSetWidget.h"

namespace viscera::app {
namespace {

/// Logical pixels: small enough that two hundred handles leave the organ to be seen.
constexpr double kRadius = 6;
constexpr double kActiveRadius = 8;
/// Handles in no group.
const Vec3 kUngrouped(0.95, 0.62, 0.20);

/// Handles that compensate are tinted so, where that matters.
const Vec3 kCompensating(0.25, 0.75, 0.85);
constexpr double kTint = 0.7;

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

} // namespace

HandleScene::HandleScene(Workspace& workspace, PoseEditor& poses, scene::OrganView& view, QObject* parent)
    : QObject(parent), workspace_(workspace), poses_(poses), view_(view) {
  using Widget = vtkVisceraHandleSetWidget;
  Widget* widget = view.handleWidget();
  widget->SetRenderOnChange(false);
  view.handles()->SetHandleRadius(kRadius);
  view.handles()->SetActiveRadius(kActiveRadius);
  const auto listen = [&](unsigned long event, std::function<void(const scene::HandleEvent&)> listener) {
    observers_.push_back(scene::observe(widget, event, std::move(listener)));
  };
  listen(Widget::HandleHoveredEvent, [this](const auto&) { Q_EMIT changed(); });
  listen(Widget::HandleGrabbedEvent, [this](const auto& event) { onGrabbed(event); });
  listen(Widget::HandleMovedEvent, [this](const auto& event) { onMoved(event); });
  listen(Widget::HandleReleasedEvent, [this](const auto&) { onReleased(); });
  listen(Widget::HandleCancelledEvent, [this](const auto&) { onCancelled(); });
  listen(Widget::SelectionChangedEvent, [this](const auto& event) { onSelected(event); });
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.rig())
      syncRig();
    if (change.rig() || change.pose())
      syncPositions();
  }));
  subscriptions_.push_back(workspace.live().onEvent([this](const live::LiveEvent& event) {
    if (event.moved)
      syncPositions();
  }));
  subscriptions_.push_back(workspace.selection().onChange([this] { syncSelection(); }));
  syncRig();
  syncPositions();
}

HandleScene::~HandleScene() {
  for (const unsigned long tag : observers_)
    view_.handleWidget()->RemoveObserver(tag);
}

void HandleScene::setMode(Mode mode) {
  if (dragging())
    view_.handleWidget()->CancelDrag();
  mode_ = mode;
  syncRig();
  syncPositions();
}

void HandleScene::setAlwaysShown(bool shown) {
  alwaysShown_ = shown;
  syncShown();
}

void HandleScene::setPlayed(bool played) {
  if (played == played_)
    return;
  played_ = played;
  syncShown();
}

void HandleScene::setShownWhere(std::function<bool(const Vec3&)> wanted) {
  shownWhere_ = std::move(wanted);
  syncShown();
}

bool HandleScene::handleUnderMouse() const {
  return dragging() || view_.handles()->GetActiveHandle() >= 0;
}

bool HandleScene::dragging() const {
  return view_.handleWidget()->IsDragging();
}

void HandleScene::syncRig() {
  const document::Rig& rig = workspace_.document().rig();
  auto* handles = view_.handles();
  if (handles->GetNumberOfHandles() != static_cast<int>(rig.handles.size()))
    handles->SetPositions(rig.restPositions());
  handles->SetColors(handleColors(rig, mode_ == Mode::deform));
  for (std::size_t row = 0; row < rig.handles.size(); ++row)
    handles->SetHandleLocked(static_cast<int>(row), rig.handles[row].locked || !editable());
  syncShown();
  syncSelection();
}

void HandleScene::syncShown() {
  const document::Rig& rig = workspace_.document().rig();
  auto* handles = view_.handles();
  if (handles->GetNumberOfHandles() != static_cast<int>(rig.handles.size()))
    return; // Somebody else heard first of another rig; this part is about to.
  for (std::size_t row = 0; row < rig.handles.size(); ++row) {
    const bool here = !shownWhere_ || shownWhere_(handles->GetPosition(static_cast<int>(row)));
    handles->SetHandleShown(static_cast<int>(row), shown() && here && rig.handles[row].visible);
    handles->SetHandleLocked(static_cast<int>(row), rig.handles[row].locked || !editable());
  }
  Q_EMIT changed();
}

void HandleScene::syncPositions() {
  if (fromWidget_)
    return;
  const Points& shown = workspace_.live().shownPose();
  if (shown.rows() != static_cast<Eigen::Index>(workspace_.document().rig().handles.size()))
    return;
  view_.handles()->SetPositions(shown);
  Q_EMIT changed();
}

void HandleScene::syncSelection() {
  const document::Rig& rig = workspace_.document().rig();
  std::vector<int> rows;
  for (const document::HandleId id : workspace_.selection().handles())
    rows.push_back(rig.indexOf(id));
  std::sort(rows.begin(), rows.end());
  view_.handles()->SetSelection(std::move(rows));
  Q_EMIT changed();
}

void HandleScene::onSelected(const scene::HandleEvent& event) {
  const document::Rig& rig = workspace_.document().rig();
  std::vector<document::HandleId> ids;
  for (const int row : view_.handles()->GetSelection())
    ids.push_back(rig.handles[row].id);
  // The clicked handle goes last: the last one is the current one.
  if (event.handle >= 0) {
    const document::HandleId clicked = rig.handles[event.handle].id;
    if (std::erase(ids, clicked) > 0)
      ids.push_back(clicked);
  }
  workspace_.selection().setHandles(ids);
}

void HandleScene::onGrabbed(const scene::HandleEvent& event) {
  const auto& rig = workspace_.document().rig();
  if (!editable() || event.handle < 0)
    return;
  dragFailed_ = false;
  const QString name = event.moving.size() > 1
                           ? tr("Move %n {handle|handles}", nullptr, static_cast<int>(event.moving.size()))
                           : tr("Move handle %1").arg(text(rig.handles[event.handle].label));
  if (posesHandles(mode_))
    beginPoseDrag(name, event);
  else
    workspace_.guarded([&] { drag_.emplace(workspace_.undo(), name.toStdString()); });
  Q_EMIT dragStarted();
}

/// The cursor moves the handle in the plane that the locked volume leaves it, when there is one.
void HandleScene::beginPoseDrag(const QString& name, const scene::HandleEvent& event) {
  const document::Rig& rig = workspace_.document().rig();
  std::vector<document::HandleId> ids;
  for (const int row : event.moving)
    ids.push_back(rig.handles[row].id);
  const bool begun = poses_.begin(name, ids, true);
  const Vec3 normal = begun ? poses_.motion()->planeNormal() : Vec3(Vec3::Zero());
  if (normal.norm() > 0)
    view_.handles()->SetConstraintPlane(normal);
}

document::Command HandleScene::moveCommand(const std::vector<int>& rows) const {
  const document::Rig& rig = workspace_.document().rig();
  std::vector<document::HandleId> ids;
  Points positions(static_cast<Eigen::Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ids.push_back(rig.handles[rows[i]].id);
    positions.row(static_cast<Eigen::Index>(i)) = view_.handles()->GetPosition(rows[i]).transpose();
  }
  return document::moveRestHandles(std::move(ids), std::move(positions));
}

void HandleScene::onMoved(const scene::HandleEvent& event) {
  if (!editable())
    return;
  if (posesHandles(mode_)) {
    poses_.translate(event.delta());
    // Where the handles are now, not where the cursor wanted them; and others that moved along.
    return syncPositions();
  }
  if (!drag_)
    return;
  const QScopedValueRollback<bool> quiet(fromWidget_, true);
  try {
    workspace_.undo().perform(moveCommand(event.moving));
  } catch (const Error& error) {
    if (!dragFailed_)
      workspace_.report(error);
    dragFailed_ = true;
  }
  Q_EMIT changed();
}

void HandleScene::onReleased() {
  view_.handles()->ClearConstraintPlane();
  if (posesHandles(mode_))
    poses_.finish();
  else if (auto drag = std::exchange(drag_, std::nullopt))
    workspace_.guarded([&] { drag->finish(); });
  syncPositions();
  Q_EMIT dragEnded();
}

void HandleScene::onCancelled() {
  view_.handles()->ClearConstraintPlane();
  if (posesHandles(mode_))
    poses_.cancel();
  else if (auto drag = std::exchange(drag_, std::nullopt))
    workspace_.guarded([&] { drag->cancel(); });
  syncPositions();
  Q_EMIT dragEnded();
}

} // namespace viscera::app
