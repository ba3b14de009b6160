#include "window/view/gizmo_scene.h"

#include "viscera/scene/vtkVisceraGizmoRepresentation.h"
#include "viscera/scene/vtkVisceraGizmoWidget.h"

namespace viscera::app {
namespace {
constexpr std::size_t kFewestHandles = 2;
} // namespace

GizmoScene::GizmoScene(Workspace& workspace, PoseEditor& poses, const ViewModel& model,
                       scene::OrganView& view, QObject* parent)
    : QObject(parent), workspace_(workspace), poses_(poses), model_(model), view_(view) {
  using Widget = vtkVisceraGizmoWidget;
  const auto listen = [this](unsigned long event, std::function<void(const scene::GizmoEvent&)> listener) {
    observers_.push_back(scene::observe(view_.gizmoWidget(), event, std::move(listener)));
  };
  listen(Widget::HoveredEvent, [this](const auto&) { Q_EMIT changed(); });
  listen(Widget::GrabbedEvent, [this](const auto& event) { onGrabbed(event); });
  listen(Widget::MovedEvent, [this](const auto& event) { onMoved(event); });
  listen(Widget::ReleasedEvent, [this](const auto&) {
    poses_.finish();
    sync();
  });
  listen(Widget::CancelledEvent, [this](const auto&) {
    poses_.cancel();
    sync();
  });
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.rig() || change.pose())
      sync();
  }));
  subscriptions_.push_back(workspace.selection().onChange([this] { sync(); }));
  connect(&model, &ViewModel::changed, this, [this] {
    if (dragging() && !wanted())
      view_.gizmoWidget()->CancelDrag();
    sync();
  });
}

GizmoScene::~GizmoScene() {
  for (const unsigned long tag : observers_)
    view_.gizmoWidget()->RemoveObserver(tag);
}

bool GizmoScene::shown() const {
  return view_.gizmo()->GetVisibility() != 0;
}

bool GizmoScene::dragging() const {
  return view_.gizmoWidget()->IsDragging();
}

bool GizmoScene::underMouse() const {
  return shown() && view_.gizmo()->GetActivePart() != vtkVisceraGizmoRepresentation::Nothing;
}

std::vector<document::HandleId> GizmoScene::movable() const {
  const document::Rig& rig = workspace_.document().rig();
  std::vector<document::HandleId> ids;
  for (const document::HandleId id : workspace_.selection().handles())
    if (const int row = rig.indexOf(id); row >= 0 && !rig.handles[static_cast<std::size_t>(row)].locked)
      ids.push_back(id);
  return ids;
}

void GizmoScene::sync() {
  if (dragging()) // It stays where it was grabbed.
    return;
  const auto handles = movable();
  const bool show = wanted() && handles.size() >= kFewestHandles;
  view_.gizmo()->SetVisibility(show);
  if (show) {
    const document::Rig& rig = workspace_.document().rig();
    std::vector<int> rows;
    for (const document::HandleId id : handles)
      rows.push_back(rig.indexOf(id));
    view_.gizmo()->SetCenter(deformation::selectionCenter(workspace_.document().pose(), rows));
  } else {
    view_.gizmo()->SetActivePart(vtkVisceraGizmoRepresentation::Nothing);
  }
  Q_EMIT changed();
}

void GizmoScene::onGrabbed(const scene::GizmoEvent& event) {
  const auto handles = movable();
  const int count = static_cast<int>(handles.size());
  const QString name = event.rotates ? tr("Turn %n {handle|handles}", nullptr, count)
                                     : tr("Scale %n {handle|handles}", nullptr, count);
  poses_.begin(name, handles, false);
}

void GizmoScene::onMoved(const scene::GizmoEvent& event) {
  if (event.rotates)
    poses_.rotate(event.center, event.axis, event.angle);
  else
    poses_.scale(event.center, event.factors);
  Q_EMIT changed();
}

} // namespace viscera::app
