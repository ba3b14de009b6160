#include "window/panels/displacement_box.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

namespace viscera::app {
namespace {
constexpr double kFarthest = 1000;
/// mm; what is nearer to the wish is as typed.
constexpr double kAsTyped = 0.005;
} // namespace

DisplacementBox::DisplacementBox(Workspace& workspace, PoseEditor& poses, QWidget* parent)
    : QWidget(parent), workspace_(workspace), poses_(poses), apply_(new QPushButton(tr("Apply"), this)),
      result_(new QLabel(this)) {
  setObjectName(QStringLiteral("displacementBox"));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(4);
  const std::array<QString, 3> names = {tr("Right to left"), tr("Front to back"), tr("Foot to head")};
  const std::array<QString, 3> tips = {tr("Towards the patient's left; negative: right (R/L)"),
                                       tr("Towards the patient's back; negative: front (A/P)"),
                                       tr("Towards the patient's head; negative: feet (S/I)")};
  for (int axis = 0; axis < 3; ++axis) {
    auto* label = new QLabel(names[axis], this);
    label->setObjectName(QStringLiteral("muted"));
    auto* field = new QDoubleSpinBox(this);
    field->setRange(-kFarthest, kFarthest);
    field->setButtonSymbols(QAbstractSpinBox::NoButtons);
    field->setDecimals(2);
    field->setSuffix(tr(" mm"));
    field->setAlignment(Qt::AlignRight);
    field->setAccessibleName(names[axis]);
    field->setToolTip(tips[axis]);
    label->setToolTip(tips[axis]);
    label->setBuddy(field);
    grid->addWidget(label, axis, 0);
    grid->addWidget(field, axis, 1);
    fields_[axis] = field;
    connect(field, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &DisplacementBox::sync);
  }
  apply_->setObjectName(QStringLiteral("applyDisplacement"));
  apply_->setToolTip(tr("Move the selected handles by this much, once; the locked volumes stay"));
  grid->addWidget(apply_, 3, 1);
  result_->setObjectName(QStringLiteral("muted"));
  result_->setWordWrap(true);
  result_->hide();
  grid->addWidget(result_, 4, 0, 1, 2);
  grid->setColumnStretch(1, 1);
  connect(apply_, &QPushButton::clicked, this, &DisplacementBox::apply);
  subscription_ = workspace.selection().onChange([this] {
    result_->hide();
    sync();
  });
  sync();
}

void DisplacementBox::sync() {
  bool any = false;
  for (const QDoubleSpinBox* field : fields_)
    any = any || field->value() != 0;
  apply_->setEnabled(any && !workspace_.selection().handles().empty());
}

void DisplacementBox::apply() {
  const Vec3 by(fields_[0]->value(), fields_[1]->value(), fields_[2]->value());
  const auto moved = poses_.moveBy(workspace_.selection().handles(), by);
  if (!moved)
    return;
  const bool asTyped = (*moved - by).norm() < kAsTyped;
  result_->setText(tr("Moved by %1 of %2 mm: the locked volume allows no more that way.")
                       .arg(moved->norm(), 0, 'f', 2)
                       .arg(by.norm(), 0, 'f', 2));
  result_->setVisible(!asTyped);
}

} // namespace viscera::app
