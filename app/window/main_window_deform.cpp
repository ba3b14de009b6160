// What Deform mode adds to the window: its actions, and what is drawn in the view.
#include <QAction>
#include <QActionGroup>

#include <algorithm>

#include "window/main_window.h"
#include "window/status_line.h"
#include "window/view/gizmo_scene.h"
#include "window/view/motion_guide.h"
#include "window/view/view_area.h"

namespace viscera::app {

void MainWindow::makeDeformScene() {
  ViewWidget* view = viewArea_->view();
  gizmoScene_ = std::make_unique<GizmoScene>(workspace_, poses_, view->view());
  motionGuide_ = std::make_unique<MotionGuide>(workspace_, poses_, view->view());
  connect(gizmoScene_.get(), &GizmoScene::changed, view, &ViewWidget::scheduleRender);
  connect(motionGuide_.get(), &MotionGuide::changed, view, &ViewWidget::scheduleRender);
  connect(&poses_, &PoseEditor::mirrorChanged, this, &MainWindow::syncDeformActions);
  // Why a drag stops is said where the hint of the mode stands.
  connect(&poses_, &PoseEditor::obstacleChanged, this, [this](const QString& obstacle) {
    for (const ModeDescription& description : modeDescriptions())
      if (description.mode == mode_)
        status_->setHint(obstacle.isEmpty() ? description.hint : tr("As far as it goes: %1").arg(obstacle));
  });
}

void MainWindow::makeDeformActions() {
  actions_
      .add("volume.lock",
           {tr("&Lock volume"),
            "lock",
            {Qt::Key_K},
            tr("Nothing in Deform mode changes the volume of the organ any more; of an organ with cavities, "
               "the "
               "volume within its outer surface")},
           [this] {
             if (const auto organ = workspace_.currentOrgan())
               poses_.setLocked(organ->id, !organ->volumeLocked);
             syncDeformActions(); // Where it was refused, the mark goes again.
           })
      ->setCheckable(true);
  actions_.add("volume.restore",
               {tr("Restore &rest volume"),
                "reset",
                {},
                tr("Give the organ the volume it has at rest, by the least motion of the handles")},
               [this] {
                 if (const auto organ = workspace_.currentOrgan())
                   poses_.setVolume(organ->id, organ->restVolumeMm3 / kMm3PerMl);
               });
  actions_
      .add("handles.compensate",
           {tr("Selected handles &compensate"),
            nullptr,
            {},
            tr("The selected handles make up for what others change of a locked volume, and no other does")},
           [this] {
             poses_.setCompensating(actions_["handles.compensate"]->isChecked());
             syncDeformActions();
           })
      ->setCheckable(true);
  actions_.addToggle("handles.gizmo",
                     {tr("&Turn and scale"),
                      "gizmo",
                      {Qt::Key_T},
                      tr("In Deform mode, rings turn and cubes scale the selected handles, two at least")},
                     false, [this](bool on) { gizmoScene_->setWanted(on); });
  makeMirrorActions();
}

void MainWindow::makeMirrorActions() {
  struct Plane {
    const char* id;
    QString name;
    Mirror mirror;
  };
  const Plane planes[] = {{"mirror.off", tr("&Off"), Mirror::off},
                          {"mirror.sagittal", tr("&Sagittal plane"), Mirror::sagittal},
                          {"mirror.coronal", tr("&Coronal plane"), Mirror::coronal},
                          {"mirror.axial", tr("&Axial plane"), Mirror::axial}};
  auto* group = new QActionGroup(this);
  for (const Plane& plane : planes) {
    QAction* action = actions_.add(
        plane.id, {plane.name, "mirror", {}, tr("In Deform mode, mirrored handles move along with a drag")},
        [this, mirror = plane.mirror] { poses_.setMirror(mirror); });
    action->setCheckable(true);
    group->addAction(action);
  }
  actions_.add("mirror.next",
               {tr("&Next mirror plane"), "mirror", {Qt::Key_M}, tr("Off, sagittal, coronal, axial, off")},
               [this] {
                 constexpr int kMirrors = 4;
                 poses_.setMirror(static_cast<Mirror>((static_cast<int>(poses_.mirror()) + 1) % kMirrors));
               });
}

void MainWindow::syncDeformActions() {
  // Their keys mean something else in other modes.
  for (const char* id : {"handles.gizmo", "mirror.next"})
    actions_[id]->setEnabled(mode_ == Mode::deform);
  const auto organ = workspace_.currentOrgan();
  actions_["volume.lock"]->setEnabled(organ != nullptr);
  actions_["volume.lock"]->setChecked(organ && organ->volumeLocked);
  actions_["volume.restore"]->setEnabled(organ && organ->closed() && !document::atRest(workspace_.state()));
  const auto& selected = workspace_.selection().handles();
  const document::Rig& rig = workspace_.document().rig();
  const bool compensating =
      !selected.empty() && std::all_of(selected.begin(), selected.end(), [&rig](document::HandleId id) {
        const int row = rig.indexOf(id);
        return row >= 0 && rig.handles[static_cast<std::size_t>(row)].compensates;
      });
  actions_["handles.compensate"]->setEnabled(!selected.empty());
  actions_["handles.compensate"]->setChecked(compensating);
  const char* const mirrors[] = {"mirror.off", "mirror.sagittal", "mirror.coronal", "mirror.axial"};
  actions_[mirrors[static_cast<int>(poses_.mirror())]]->setChecked(true);
}

} // namespace viscera::app
