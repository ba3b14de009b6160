#include "window/organs/cut_box.h"

#include <QAction>
#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QPushButton>

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include "viscera/presentation/opened_heart.h"
#include "window/style/language.h"
#include "window/view/cut_sight.h"
#include "window/widgets/ready_made.h"
#include "window/widgets/value_slider.h"

namespace viscera::app {

CutBox::CutBox(Workspace& workspace, ViewModel& view, ViewWidget& widget, const Actions& actions,
               QWidget* parent)
    : QWidget(parent), workspace_(workspace), view_(view), widget_(widget) {
  auto* column = makeLayout<QVBoxLayout>(this, 6);
  column->addWidget(makeSwitches(actions));
  directions_ = makeDirections();
  column->addWidget(directions_);
  offset_ = new ValueSlider(tr("Depth"), {-kPercent, kPercent, 1, 0, QStringLiteral(" %")}, this);
  offset_->setObjectName(QStringLiteral("cutOffset"));
  offset_->setToolTip(
      tr("Distance of the cut from the middle of the organs, in per cent of the distance to their edge"));
  column->addWidget(offset_);
  connect(offset_, &ValueSlider::valueChanged, this, [this](double value) {
    view_.change([value](presentation::ViewState& state) { state.cut.offset = value / kPercent; });
  });
  connect(&view, &ViewModel::changed, this, &CutBox::sync);
  subscription_ = workspace.onChange([this](const document::Change& change) {
    if (change.organs())
      sync();
  });
  sync();
}

QWidget* CutBox::makeSwitches(const Actions& actions) {
  auto* row = new QWidget(this);
  auto* line = makeLayout<QHBoxLayout>(row, 6);
  auto* check = new QCheckBox(actions["view.cut"]->iconText(), row);
  check->setToolTip(actions["view.cut"]->toolTip());
  connect(check, &QCheckBox::toggled, actions["view.cut"], &QAction::setChecked);
  connect(actions["view.cut"], &QAction::toggled, check, &QCheckBox::setChecked);
  check->setChecked(actions["view.cut"]->isChecked());
  line->addWidget(check);
  blood_ = new QCheckBox(tr("Blood"), row);
  blood_->setObjectName(QStringLiteral("cutBlood"));
  blood_->setToolTip(
      tr("Fill chambers and vessels of the heart with blood. Without it they are empty and show walls, "
         "papillary muscles and valves"));
  connect(blood_, &QCheckBox::toggled, this,
          [this](bool on) { view_.change([on](presentation::ViewState& state) { state.cut.blood = on; }); });
  line->addWidget(blood_);
  line->addStretch();
  return row;
}

QWidget* CutBox::makeDirections() {
  auto* box = new QWidget(this);
  auto* grid = makeLayout<QGridLayout>(box, 4);
  struct Direction {
    QString name;
    QString tip;
    Vec3 normal; ///< Zero: along the sight.
  };
  const Direction directions[] = {
      {tr("Coronal"), tr("Cut away the front"), Vec3::UnitY()},
      {tr("Sagittal"), tr("Cut away the left side"), -Vec3::UnitX()},
      {tr("Axial"), tr("Cut away the upper part"), -Vec3::UnitZ()},
      {tr("Facing the viewer"), tr("Cut away the part nearest to the viewer"), Vec3::Zero()}};
  int index = 0;
  for (const Direction& direction : directions) {
    auto* button = new QPushButton(direction.name, box);
    button->setToolTip(direction.tip);
    connect(button, &QPushButton::clicked, this, [this, normal = direction.normal] { cutFrom(normal); });
    grid->addWidget(button, index / 2, index % 2);
    ++index;
  }
  return box;
}

void CutBox::cutFrom(const Vec3& normal) {
  Vec3 chosen = normal;
  if (!chosen.isZero()) {
    seeCut(widget_.view(), chosen);
    widget_.scheduleRender();
  } else {
    double sight[3];
    widget_.view().renderer()->GetActiveCamera()->GetDirectionOfProjection(sight);
    chosen = Vec3(sight).normalized();
  }
  view_.change([&chosen](presentation::ViewState& state) { state.cut = {true, chosen, 0, state.cut.blood}; });
}

void CutBox::sync() {
  const presentation::OrganCut& cut = view_.state().cut;
  directions_->setEnabled(cut.on);
  offset_->setEnabled(cut.on);
  offset_->setValue(kPercent * cut.offset);
  blood_->setVisible(presentation::openedHeart(workspace_.state(), view_.state()).has_value());
  blood_->setChecked(cut.blood);
}

} // namespace viscera::app
