#include "window/deform/deform_mode.h"

#include <QAction>
#include <QActionGroup>

#include <algorithm>

#include "viscera/document/rig_commands.h"
#include "window/deform/deform_page.h"
#include "window/view/view_model.h"
#include "window/work/actions.h"

namespace viscera::app {
namespace {

bool compensates(const document::Rig& rig, document::HandleId id) {
  const int row = rig.indexOf(id);
  return row >= 0 && rig.handles[static_cast<std::size_t>(row)].compensates;
}

} // namespace

DeformMode::DeformMode(const ModeParts& parts, Actions& actions)
    : Mode(parts,
           {"deform", "deform", 3, tr("Deform"),
            tr("Drag a handle and the organ follows; K locks the volume, T turns and scales, M mirrors")}),
      ghost_(parts) {
  makePoseActions(actions);
  makeVolumeActions(actions);
  makeCompensate(actions);
  parts_.view.addToggle(
      actions, "handles.gizmo",
      {tr("&Turn and scale"),
       "gizmo",
       {Qt::Key_T},
       tr("In Deform mode, rings turn and cubes scale the selected handles (at least two)")},
      &presentation::ViewState::gizmo);
  makeMirrorActions(actions);
  // The keys mean something else in other modes.
  actions.enableWhile({"handles.gizmo", "mirror.next"}, [this] { return parts_.view.state().shown.tools; });
}

void DeformMode::makePoseActions(Actions& actions) {
  actions.add("pose.reset",
              {tr("Reset &pose"), "reset", {tr("Ctrl+R")}, tr("Move every handle back to its rest position")},
              [this] { workspace_.perform(document::resetPose()); });
  actions.add("pose.resetSelected",
              {tr("Reset selected handles"),
               "reset",
               {tr("Ctrl+Shift+R")},
               tr("Move the selected handles back to their rest positions")},
              [this] { parts_.poses.reset(workspace_.selection().handles()); });
  actions.enableWhile({"pose.reset"}, [this] { return !document::atRest(workspace_.state()); });
  actions.enableWhile({"pose.resetSelected"}, [this] { return !workspace_.selection().handles().empty(); });
}

void DeformMode::makeVolumeActions(Actions& actions) {
  actions.add("volume.restore",
              {tr("Restore &rest volume"),
               "reset",
               {},
               tr("Restore the organ's volume at rest with the smallest motion of the handles")},
              [this] {
                if (const auto organ = workspace_.currentOrgan())
                  parts_.poses.setVolume(organ->id, organ->restVolumeMm3 / kMm3PerMl);
              });
  actions.enableWhile({"volume.restore"}, [this] {
    const auto organ = workspace_.currentOrgan();
    return organ && organ->closed() && !document::atRest(workspace_.state());
  });
}

void DeformMode::makeCompensate(Actions& actions) {
  QAction* compensate =
      actions.add("handles.compensate",
                  {tr("Selected handles &compensate"),
                   nullptr,
                   {},
                   tr("Only the selected handles compensate when others would change a locked volume")},
                  [this, &actions] {
                    parts_.poses.setCompensating(actions["handles.compensate"]->isChecked());
                    actions.sync();
                  });
  compensate->setCheckable(true);
  parts_.view.addToggle(actions, "handles.follow",
                        {tr("&Free handles follow"),
                         nullptr,
                         {},
                         tr("Handles that you do not drag go to where the elastic energy of the organs' "
                            "tissue is least; locked "
                            "handles hold it, else it moves as a whole. Locked volumes stay exact. The first "
                            "drag takes about a "
                            "second, the next ones a tenth of a second a step")},
                        &presentation::ViewState::freeHandlesFollow);
  parts_.view.addToggle(
      actions, "pose.elasticity",
      {tr("&Beside elasticity"),
       nullptr,
       {},
       tr("Show the current organ as an elastic body that the moved handles grip, as a ghost, "
          "and colour the organ by the distance from it; the other handles hold it. It takes "
          "some seconds after each drag")},
      &presentation::ViewState::besideElasticity);
  parts_.view.addToggle(
      actions, "handles.exactly",
      {tr("Move e&xactly, others compensate"),
       nullptr,
       {},
       tr("Under a locked volume, moved handles go exactly where they are sent, and the others compensate; "
          "else a moved handle stays where the volume lets it")},
      &presentation::ViewState::exactly);
  actions.onSync([this, compensate] {
    const auto& selected = workspace_.selection().handles();
    const document::Rig& rig = workspace_.document().rig();
    compensate->setEnabled(!selected.empty());
    compensate->setChecked(!selected.empty() &&
                           std::all_of(selected.begin(), selected.end(),
                                       [&rig](document::HandleId id) { return compensates(rig, id); }));
  });
}

void DeformMode::makeMirrorActions(Actions& actions) {
  using presentation::Mirror;
  struct Plane {
    const char* id;
    QString name;
    Mirror mirror;
  };
  const Plane planes[] = {{"mirror.off", tr("&Off"), Mirror::off},
                          {"mirror.sagittal", tr("&Sagittal plane"), Mirror::sagittal},
                          {"mirror.coronal", tr("&Coronal plane"), Mirror::coronal},
                          {"mirror.axial", tr("&Axial plane"), Mirror::axial}};
  const auto choose = [this](Mirror mirror) {
    parts_.view.change([mirror](presentation::ViewState& view) { view.mirror = mirror; });
  };
  auto* group = new QActionGroup(this);
  for (const Plane& plane : planes) {
    QAction* action = actions.addToggle(
        plane.id, {plane.name, "mirror", {}, tr("In Deform mode, mirrored handles move along with a drag")},
        plane.mirror == Mirror::off, [choose, mirror = plane.mirror](bool on) {
          if (on)
            choose(mirror);
        });
    group->addAction(action);
    actions.onSync([this, action, mirror = plane.mirror] {
      if (parts_.view.state().mirror == mirror)
        action->setChecked(true);
    });
  }
  actions.add("mirror.next",
              {tr("&Next mirror plane"),
               "mirror",
               {Qt::Key_M},
               tr("Switch between off, sagittal, coronal and axial")},
              [this, choose] {
                constexpr int kMirrors = 4;
                choose(static_cast<Mirror>((static_cast<int>(parts_.view.state().mirror) + 1) % kMirrors));
              });
}

QWidget* DeformMode::makePage(const Actions& actions) {
  return new DeformPage(parts_, actions, ghost_);
}

} // namespace viscera::app
