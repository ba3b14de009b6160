#include "window/deform/deform_page.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

#include <utility>

#include "viscera/presentation/presenter.h"
#include "window/deform/elastic_ghost.h"
#include "window/handles/position_box.h"
#include "window/style/language.h"
#include "window/timeline/volume_monitor.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {

constexpr double kSmallestTargetMl = 0.001;
constexpr double kLargestTargetMl = 100000;

/// "H-3, H-7", or how many there are when that would be long.
QString namesOf(const document::Rig& rig, const std::vector<document::HandleId>& handles) {
  constexpr std::size_t kMostNames = 4;
  if (handles.size() > kMostNames)
    return DeformPage::tr("%n handles", nullptr, static_cast<int>(handles.size()));
  QStringList names;
  for (const document::HandleId id : handles)
    if (const int row = rig.indexOf(id); row >= 0)
      names.push_back(inWords(rig.handles[static_cast<std::size_t>(row)].label));
  return names.join(QStringLiteral(", "));
}

} // namespace

/// The controls that give the current organ a typed volume, or its volume at rest.
class VolumeBox final : public QWidget {
  Q_OBJECT

public:
  VolumeBox(Workspace& workspace, PoseEditor& poses, QWidget* parent = nullptr);

  /// Shows the present volume, unless another one was typed.
  void sync();

private:
  Workspace& workspace_;
  PoseEditor& poses_;
  QDoubleSpinBox* field_;
  QPushButton* apply_;
  document::OrganId shown_; ///< The organ whose volume the field shows.
  bool typed_ = false;      ///< A number was typed and is not applied yet.
};

VolumeBox::VolumeBox(Workspace& workspace, PoseEditor& poses, QWidget* parent)
    : QWidget(parent), workspace_(workspace), poses_(poses), field_(new QDoubleSpinBox(this)),
      apply_(new QPushButton(tr("Apply"), this)) {
  setObjectName(QStringLiteral("volumeBox"));
  auto* row = makeLayout<QHBoxLayout>(this, 8);
  auto* label = new QLabel(tr("Target"), this);
  label->setObjectName(QStringLiteral("muted"));
  label->setBuddy(field_);
  field_->setObjectName(QStringLiteral("targetVolume"));
  field_->setRange(kSmallestTargetMl, kLargestTargetMl);
  field_->setDecimals(1);
  field_->setSuffix(tr(" ml"));
  field_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  field_->setAlignment(Qt::AlignRight);
  field_->setKeyboardTracking(false);
  field_->setAccessibleName(tr("Target volume"));
  field_->setToolTip(tr("Give the organ this volume with the smallest motion of the compensating handles, or "
                        "of all free ones"));
  apply_->setObjectName(QStringLiteral("applyVolume"));
  apply_->setToolTip(field_->toolTip());
  row->addWidget(label);
  row->addWidget(field_, 1);
  row->addWidget(apply_);
  connect(field_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this] { typed_ = true; });
  connect(apply_, &QPushButton::clicked, this, [this] {
    const auto organ = workspace_.currentOrgan();
    if (organ && poses_.setVolume(organ->id, field_->value()) && organ->volumeLocked)
      workspace_.note(tr("%1 now has the target volume; its lock keeps this volume from now on.")
                          .arg(inWords(presentation::labelOf(*organ))));
    apply_->setFocus();
    typed_ = false;
    sync();
  });
  sync();
}

void VolumeBox::sync() {
  const auto organ = workspace_.currentOrgan();
  const live::OrganVolume volume = organ ? workspace_.live().volume(organ->id) : live::OrganVolume();
  setEnabled(volume.closed && organ && workspace_.live().deformer(organ->id));
  const document::OrganId current = organ ? organ->id : document::OrganId();
  if (std::exchange(shown_, current) != current)
    typed_ = false;
  if (typed_ || field_->hasFocus() || !volume.closed)
    return;
  const QSignalBlocker quiet(field_);
  field_->setDecimals(volume.restMl < 10 ? 3 : 1);
  field_->setValue(volume.nowMl);
}

DeformPage::DeformPage(const ModeParts& parts, const Actions& actions, const ElasticGhost& ghost,
                       QWidget* parent)
    : Page(parent), workspace_(parts.workspace), poses_(parts.poses), view_(parts.view), ghost_(ghost) {
  addSection(tr("Volume"));
  organ_ = addFact(tr("Organ"));
  organ_->setObjectName(QStringLiteral("deformOrgan"));
  now_ = addFact(tr("Now"));
  rest_ = addFact(tr("Rest shape"));
  change_ = addFact(tr("Change"));
  farthest_ = addFact(tr("Largest shift"));
  farthest_->setToolTip(tr("The largest distance by which a vertex of the organ has moved from rest"));
  addCheck(actions["volume.lock"]);
  add(volume_ = new VolumeBox(workspace_, poses_, this));
  addButton(actions["volume.restore"]);
  addSection(tr("Selected handles"));
  add(new PositionBox(workspace_, PositionBox::Of::pose, this, &poses_));
  add(new DisplacementBox(workspace_, poses_, this));
  addCheck(actions["handles.gizmo"]);
  addCheck(actions["handles.follow"]);
  addCheck(actions["handles.exactly"]);
  addCheck(actions["handles.compensate"]);
  compensating_ = addFact(tr("Compensating"));
  compensating_->setToolTip(
      tr("These handles compensate when others would change a locked volume. If none is marked, a dragged "
         "handle stays in a plane, and all free handles compensate for other motions."));
  addSection(tr("Symmetric drags"));
  addMirror();
  addSection(tr("Pose"));
  moved_ = addFact(tr("Handles moved"));
  moved_->setObjectName(QStringLiteral("handlesMoved"));
  addButton(actions["pose.reset"]);
  addButton(actions["pose.resetSelected"]);
  addCheck(actions["view.ghost"]);
  addCheck(actions["handles.influence"]);
  addButton(actions["play.compareSystems"]);
  addElasticity(actions);
  finish();
  connect(&parts.volumes, &VolumeMonitor::updated, this, &DeformPage::sync);
  connect(&parts.volumes, &VolumeMonitor::shown, this, [this] {
    if (isVisible()) // Another page is there while a sequence plays.
      sync();
  });
  connect(&view_, &ViewModel::changed, this, &DeformPage::syncHandles);
  connect(&ghost_, &ElasticGhost::changed, this, &DeformPage::syncElasticity);
  subscriptions_.push_back(workspace_.onChange([this](const document::Change& change) {
    if (!change.interactive)
      sync();
    else if (change.pose())
      syncMoved();
    if (change.rig() || change.organs())
      syncHandles();
  }));
  subscriptions_.push_back(workspace_.selection().onChange([this] {
    sync();
    syncHandles();
  }));
  sync();
  syncHandles();
  syncElasticity();
}

void DeformPage::addElasticity(const Actions& actions) {
  addSection(tr("Elasticity"));
  addCheck(actions["pose.elasticity"]);
  elasticMedian_ = addFact(tr("Median distance"));
  elasticMedian_->setObjectName(QStringLiteral("elasticMedian"));
  elasticLargest_ = addFact(tr("Largest distance"));
  elasticLargest_->setObjectName(QStringLiteral("elasticLargest"));
  elasticReason_ = addRemark({});
  elasticReason_->setObjectName(QStringLiteral("elasticReason"));
}

/// A page without the switch has no lines of dashes.
void DeformPage::syncElasticity() {
  const auto& apart = ghost_.apart();
  setFactShown(elasticMedian_, apart.has_value());
  setFactShown(elasticLargest_, apart.has_value());
  if (apart) {
    elasticMedian_->setText(tr("%1 mm").arg(formatNumber(apart->medianMm, 2)));
    elasticLargest_->setText(tr("%1 mm").arg(formatNumber(apart->maxMm, 2)));
  }
  elasticReason_->setText(ghost_.reason());
  elasticReason_->setVisible(!ghost_.reason().isEmpty());
}

void DeformPage::addMirror() {
  mirror_ = new QComboBox(this);
  mirror_->setObjectName(QStringLiteral("mirror"));
  mirror_->setAccessibleName(tr("Mirror plane"));
  mirror_->addItems({tr("Off"), tr("Sagittal plane (left and right)"), tr("Coronal plane (front and back)"),
                     tr("Axial plane (head and feet)")});
  mirror_->setToolTip(tr("A drag moves the mirrored handles too; the mirror plane passes through the middle "
                         "of the organ at rest (M: next plane)"));
  mirror_->setMinimumContentsLength(8);
  mirror_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  add(mirror_);
  partners_ = addFact(tr("Moves along"));
  connect(mirror_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
    view_.change(
        [index](presentation::ViewState& view) { view.mirror = static_cast<presentation::Mirror>(index); });
  });
}

void DeformPage::sync() {
  const auto organ = workspace_.currentOrgan();
  const QString none = QStringLiteral("-");
  const live::OrganVolume volume = organ ? workspace_.live().volume(organ->id) : live::OrganVolume();
  organ_->setText(organ ? inWords(presentation::labelOf(*organ)) : none);
  now_->setText(volume.closed ? formatMilliliters(volume.nowMl) : none);
  rest_->setText(volume.closed ? formatMilliliters(volume.restMl) : none);
  change_->setText(volume.closed ? tr("%1 (%2)").arg(formatChange(volume), formatRelativeChange(volume))
                                 : none);
  deformation::Deformer* deformer = organ ? workspace_.live().deformer(organ->id) : nullptr;
  farthest_->setText(deformer ? tr("%1 mm").arg(formatNumber(deformer->maxDisplacementMm(), 1)) : none);
  volume_->sync();
  syncMoved();
}

void DeformPage::syncMoved() {
  const Points rest = workspace_.document().rig().restPositions();
  const Points& pose = workspace_.document().pose();
  int moved = 0;
  for (Eigen::Index row = 0; row < pose.rows(); ++row)
    moved += pose.row(row) != rest.row(row);
  moved_->setText(tr("%1 of %2").arg(moved).arg(pose.rows()));
}

void DeformPage::syncHandles() {
  const document::Rig& rig = workspace_.document().rig();
  std::vector<document::HandleId> marked;
  for (const document::Handle& handle : rig.handles)
    if (handle.compensates)
      marked.push_back(handle.id);
  compensating_->setText(marked.empty() ? tr("all free handles") : namesOf(rig, marked));
  const QSignalBlocker quiet(mirror_);
  const presentation::Mirror mirror = view_.state().mirror;
  mirror_->setCurrentIndex(static_cast<int>(mirror));
  const bool selected = !workspace_.selection().handles().empty();
  const auto partners = poses_.partnersOfSelection();
  partners_->setText(mirror == presentation::Mirror::off || !selected ? QStringLiteral("-")
                     : partners.empty() ? tr("no handle is near the mirror image")
                                        : namesOf(rig, partners));
}

} // namespace viscera::app

#include "deform_page.moc"
