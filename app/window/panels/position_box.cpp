#include "window/panels/position_box.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "viscera/document/rig_commands.h"

namespace viscera::app {
namespace {
constexpr double kFarthest = 10000;
} // namespace

PositionBox::PositionBox(Workspace& workspace, Of what, QWidget* parent, PoseEditor* poses)
    : QWidget(parent), workspace_(workspace), what_(what), poses_(poses), title_(new QLabel(this)),
      fieldBox_(new QWidget(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  title_->setWordWrap(true);
  column->addWidget(title_);
  column->addWidget(fieldBox_);
  auto* grid = new QGridLayout(fieldBox_);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(4);
  const std::array<QString, 3> names = {tr("Left"), tr("Posterior"), tr("Superior")};
  for (int axis = 0; axis < 3; ++axis) {
    auto* label = new QLabel(names[axis], fieldBox_);
    label->setObjectName(QStringLiteral("muted"));
    auto* field = new QDoubleSpinBox(fieldBox_);
    field->setRange(-kFarthest, kFarthest);
    field->setButtonSymbols(QAbstractSpinBox::NoButtons);
    field->setDecimals(2);
    field->setSingleStep(1);
    field->setSuffix(tr(" mm"));
    field->setAlignment(Qt::AlignRight);
    field->setKeyboardTracking(false);
    field->setAccessibleName(names[axis]);
    label->setBuddy(field);
    grid->addWidget(label, axis, 0);
    grid->addWidget(field, axis, 1);
    fields_[axis] = field;
    connect(field, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &PositionBox::commit);
  }
  grid->setColumnStretch(1, 1);
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.rig() || change.pose())
      sync();
  }));
  subscriptions_.push_back(workspace.selection().onChange([this] { sync(); }));
  sync();
}

Vec3 PositionBox::present(int row) const {
  const document::Document& document = workspace_.document();
  return what_ == Of::rest ? document.rig().handles[row].rest : Vec3(document.pose().row(row).transpose());
}

void PositionBox::sync() {
  const document::Rig& rig = workspace_.document().rig();
  const int row = rig.indexOf(workspace_.selection().currentHandle());
  fieldBox_->setVisible(row >= 0);
  if (row < 0) {
    title_->setText(tr("No handle is selected. Click one in the view or in the list."));
    title_->setObjectName(QStringLiteral("muted"));
    return;
  }
  const document::Handle& handle = rig.handles[row];
  const double moved = (workspace_.document().pose().row(row).transpose() - handle.rest).norm();
  QString line = tr("Handle %1").arg(text(handle.label));
  if (what_ == Of::pose)
    line += tr(", %1 mm from rest").arg(moved, 0, 'f', 1);
  if (handle.locked)
    line += tr(", locked");
  title_->setText(line);
  const Vec3 place = present(row);
  for (int axis = 0; axis < 3; ++axis) {
    const QSignalBlocker quiet(fields_[axis]);
    fields_[axis]->setValue(place[axis]);
    fields_[axis]->setEnabled(!handle.locked);
  }
}

void PositionBox::commit() {
  const document::HandleId id = workspace_.selection().currentHandle();
  const int row = workspace_.document().rig().indexOf(id);
  if (row < 0)
    return;
  // A number that was not typed keeps its digits beyond those shown.
  Vec3 place = present(row);
  for (int axis = 0; axis < 3; ++axis) {
    const double shown = QString::number(place[axis], 'f', fields_[axis]->decimals()).toDouble();
    if (fields_[axis]->value() != shown)
      place[axis] = fields_[axis]->value();
  }
  if (what_ == Of::pose && poses_) {
    poses_->moveBy({id}, place - present(row));
    return sync(); // The place may be another one than was typed: as near as the locked volumes allow.
  }
  Points positions = place.transpose();
  if (!workspace_.perform(what_ == Of::rest ? document::moveRestHandles({id}, positions)
                                            : document::moveHandles({id}, positions)))
    sync();
}

} // namespace viscera::app
