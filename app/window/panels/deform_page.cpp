#include "window/panels/deform_page.h"

#include <QLabel>

#include "window/panels/position_box.h"

namespace viscera::app {

DeformPage::DeformPage(Workspace& workspace, VolumeMonitor& volumes, const Actions& actions, QWidget* parent)
    : Page(parent), workspace_(workspace) {
  addSection(tr("Volume"));
  now_ = addFact(tr("Now"));
  rest_ = addFact(tr("At rest"));
  change_ = addFact(tr("Change"));
  farthest_ = addFact(tr("Largest shift"));
  farthest_->setToolTip(tr("How far the organ's surface has moved from rest, at most"));
  addSection(tr("Pose"));
  moved_ = addFact(tr("Handles moved"));
  addButton(actions["pose.reset"]);
  addButton(actions["pose.resetSelected"]);
  addCheck(actions["view.ghost"]);
  addCheck(actions["handles.influence"]);
  addSection(tr("Handle in the pose"));
  add(new PositionBox(workspace, PositionBox::Of::pose, this));
  finish();
  connect(&volumes, &VolumeMonitor::updated, this, &DeformPage::sync);
  subscriptions_.push_back(workspace.onChange([this](const session::Change& change) {
    if (!change.interactive)
      sync();
  }));
  subscriptions_.push_back(workspace.selection().onChange([this] { sync(); }));
  sync();
}

void DeformPage::sync() {
  const auto organ = workspace_.currentOrgan();
  const QString none = QStringLiteral("-");
  const session::OrganVolume volume = organ ? workspace_.live().volume(organ->id) : session::OrganVolume();
  now_->setText(volume.closed ? formatMilliliters(volume.nowMl) : none);
  rest_->setText(volume.closed ? formatMilliliters(volume.restMl) : none);
  change_->setText(volume.closed ? tr("%1%2 ml (%3 %)")
                                       .arg(volume.changeMl() > 0 ? QStringLiteral("+") : QString())
                                       .arg(volume.changeMl(), 0, 'f', 1)
                                       .arg(100 * volume.relativeChange(), 0, 'f', 1)
                                 : none);
  deformation::Deformer* deformer = organ ? workspace_.live().deformer(organ->id) : nullptr;
  farthest_->setText(deformer ? tr("%1 mm").arg(deformer->maxDisplacementMm(), 0, 'f', 1) : none);
  const Points rest = workspace_.document().rig().restPositions();
  const Points& pose = workspace_.document().pose();
  int moved = 0;
  for (Eigen::Index row = 0; row < pose.rows(); ++row)
    moved += pose.row(row) != rest.row(row);
  moved_->setText(tr("%1 of %2").arg(moved).arg(pose.rows()));
}

} // namespace viscera::app
