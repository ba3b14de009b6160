#include "window/import/repair_value_box.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include <algorithm>
#include <utility>

#include "viscera/medical_io/plausible_size.h"
#include "viscera/medical_io/surface_repairs.h"
#include "window/import/organ_check.h"
#include "window/style/language.h"
#include "window/widgets/ready_made.h"
#include "window/work/workspace.h"

namespace viscera::app {
namespace {

constexpr int kValueDecimals = 3, kFactorDecimals = 6;
/// What pieces of organs are asked for first, by the unit.
constexpr double kFirstMm = 10, kFirstMl = 0.5;

} // namespace

RepairValueBox::RepairValueBox(const document::DraftOrgan& organ, std::string repair, QWidget* parent)
    : QFrame(parent), mesh_(organ.mesh), repair_(std::move(repair)), sizeMm_(organ.assessment.sizeMm),
      volumeMl_(organ.assessment.volumeMl), lifeSize_(medical_io::lifeSizeFactor(organ.name, volumeMl_)),
      value_(new QDoubleSpinBox), unit_(new QComboBox), effect_(makeRemark({}, this)) {
  setObjectName(QStringLiteral("repairValue"));
  if (repair_ == "remove-fragments")
    pieces_ = std::make_unique<medical_io::SurfacePieces>(*mesh_);
  auto* column = makeLayout<QVBoxLayout>(this, 4, {0, 4, 0, 4});
  auto* heading = new QLabel(repairName(repair_), this);
  embolden(heading);
  column->addWidget(heading);
  column->addWidget(makeValue());
  effect_->setObjectName(QStringLiteral("repairEffect"));
  column->addWidget(effect_);
  column->addWidget(makeButtons());
  setUnit();
}

QWidget* RepairValueBox::makeValue() {
  auto* row = new QWidget(this);
  auto* layout = makeLayout<QHBoxLayout>(row, 4);
  value_->setAccessibleName(repairName(repair_));
  value_->setKeyboardTracking(false);
  layout->addWidget(value_, 1);
  const medical_io::RepairValue range =
      *medical_io::surfaceRepair(repair_ == "scale" ? "scale=1" : repair_).value;
  for (const std::string& unit : range.units)
    unit_->addItem(text(unit));
  unit_->setAccessibleName(tr("Unit"));
  layout->addWidget(unit_);
  unit_->setVisible(range.units.size() > 1);
  value_->setDecimals(repair_ == "scale" ? kFactorDecimals : kValueDecimals);
  value_->setRange(range.low, range.high);
  if (repair_ == "remesh")
    value_->setRange(medical_io::finestResolutionMm(*mesh_), sizeMm_.maxCoeff());
  if (repair_ == "scale" && lifeSize_) {
    auto* life = new QPushButton(tr("Life size"), row);
    life->setObjectName(QStringLiteral("lifeSize"));
    life->setToolTip(tr("The factor by which the organ gets the usual volume of its kind"));
    connect(life, &QPushButton::clicked, this, [this] { value_->setValue(*lifeSize_); });
    layout->addWidget(life);
  }
  connect(value_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &RepairValueBox::tell);
  connect(unit_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &RepairValueBox::setUnit);
  return row;
}

QWidget* RepairValueBox::makeButtons() {
  auto* row = new QWidget(this);
  auto* layout = makeLayout<QHBoxLayout>(row, 4);
  auto* apply = new QPushButton(tr("Apply"), row);
  apply->setObjectName(QStringLiteral("applyRepair"));
  auto* cancel = new QPushButton(tr("Cancel"), row);
  layout->addWidget(apply);
  layout->addWidget(cancel);
  layout->addStretch(1);
  connect(apply, &QPushButton::clicked, this, [this] { Q_EMIT chosen(id()); });
  connect(cancel, &QPushButton::clicked, this, &RepairValueBox::closed);
  return row;
}

/// A value in another unit is another value.
void RepairValueBox::setUnit() {
  const QString unit = unit_->currentText();
  double first = 1;
  if (repair_ == "remesh")
    first = medical_io::usualResolutionMm(*mesh_);
  else if (repair_ == "remove-fragments")
    first = unit == QLatin1String("mm")   ? kFirstMm
            : unit == QLatin1String("ml") ? kFirstMl
                                          : medical_io::FragmentLimit{}.value;
  value_->setSuffix(unit.isEmpty() ? QString() : QStringLiteral(" ") + unit);
  value_->setValue(first);
  tell();
}

QString RepairValueBox::id() const {
  const QString unit = repair_ == "remove-fragments" ? unit_->currentText() : QString();
  return QStringLiteral("%1=%2%3").arg(text(repair_), QString::number(value_->value(), 'g', 9), unit);
}

QString RepairValueBox::effect() const {
  if (pieces_) {
    const std::string words = id().section(QLatin1Char('='), 1).toStdString();
    const auto limit = medical_io::fragmentLimit(words);
    return asSentence(medical_io::describeFragments(*pieces_, limit.value_or(medical_io::FragmentLimit{})));
  }
  if (repair_ == "remesh")
    return tr("About %1 triangles. Details smaller than %2 mm are lost.")
        .arg(locale().toString(medical_io::trianglesAt(*mesh_, value_->value())))
        .arg(formatDigits(value_->value(), 2));
  const Vec3 size = value_->value() * sizeMm_;
  const auto number = [](double value) { return formatDigits(value, 3); };
  const double volumeMl = volumeMl_ * value_->value() * value_->value() * value_->value();
  const QString box =
      OrganCheck::tr("%1 x %2 x %3 mm").arg(number(size.x()), number(size.y()), number(size.z()));
  return volumeMl > 0 ? OrganCheck::tr("%1, %2").arg(box, formatMilliliters(volumeMl)) : box;
}

void RepairValueBox::tell() {
  effect_->setText(effect());
  Q_EMIT changed(id());
}

} // namespace viscera::app
