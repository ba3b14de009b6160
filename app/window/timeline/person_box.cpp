#include "window/timeline/person_box.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QSignalBlocker>

#include "window/view/view_model.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {

constexpr double kStep = 0.05;
/// One step below the smallest: not known.
constexpr double kAnySize = anatomy::kSmallestBodySurfaceM2 - kStep;

} // namespace

PersonBox::PersonBox(ViewModel& view, QWidget* parent)
    : QWidget(parent), view_(view), sex_(new QComboBox(this)), surface_(new QDoubleSpinBox(this)) {
  auto* row = makeLayout<QHBoxLayout>(this, 4);
  sex_->setObjectName(QStringLiteral("rangesOf"));
  sex_->addItem(tr("Women and men"), static_cast<int>(anatomy::Sex::either));
  sex_->addItem(tr("Women"), static_cast<int>(anatomy::Sex::women));
  sex_->addItem(tr("Men"), static_cast<int>(anatomy::Sex::men));
  sex_->setToolTip(tr("Whose normal ranges are shown"));
  surface_->setObjectName(QStringLiteral("rangesForBodySurface"));
  surface_->setDecimals(2);
  surface_->setSingleStep(kStep);
  surface_->setRange(kAnySize, anatomy::kLargestBodySurfaceM2);
  surface_->setSuffix(tr(" m\u00b2"));
  surface_->setSpecialValueText(tr("any body surface area"));
  surface_->setToolTip(
      tr("Body surface area: ranges that the source gives per square metre are scaled by it"));
  row->addWidget(sex_);
  row->addWidget(surface_);
  connect(sex_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &PersonBox::choose);
  connect(surface_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &PersonBox::choose);
  connect(&view, &ViewModel::changed, this, &PersonBox::sync);
  sync();
}

void PersonBox::choose() {
  anatomy::Person person;
  person.sex = static_cast<anatomy::Sex>(sex_->currentData().toInt());
  if (surface_->value() > surface_->minimum())
    person.bodySurfaceM2 = surface_->value();
  view_.change([&](presentation::ViewState& state) { state.person = person; });
}

void PersonBox::sync() {
  const anatomy::Person& person = view_.state().person;
  const QSignalBlocker quietSex(sex_), quietSurface(surface_);
  sex_->setCurrentIndex(sex_->findData(static_cast<int>(person.sex)));
  surface_->setValue(person.bodySurfaceM2 > 0 ? person.bodySurfaceM2 : surface_->minimum());
}

} // namespace viscera::app
