#include "window/stress/probe_card.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include "viscera/presentation/slice_presenter.h"
#include "window/style/language.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {

ProbeCard::ProbeCard(StressModel& model, QAction* pin, QWidget* parent)
    : QFrame(parent), model_(model), place_(new QLabel(this)), position_(new QLabel(this)) {
  setObjectName(QStringLiteral("badge"));
  auto* grid = makeLayout<QGridLayout>(this, -1, {12, 8, 8, 10});
  grid->setHorizontalSpacing(16);
  grid->setVerticalSpacing(3);
  auto* close = makeIconButton("close", tr("Close (Esc)"), this, 12);
  close->setAccessibleName(tr("Close"));
  connect(close, &QToolButton::clicked, this, [this] { model_.setProbe(-1); });
  place_->setObjectName(QStringLiteral("probePlace"));
  grid->addWidget(place_, 0, 0);
  grid->addWidget(close, 0, 1, Qt::AlignRight);
  position_->setObjectName(QStringLiteral("probePosition"));
  position_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  position_->setToolTip(
      tr("Towards the right (R) or left (L), front (A) or back (P), foot (I) or head (S), mm"));
  grid->addWidget(position_, 1, 0, 1, 2);
  int row = 2;
  for (const live::StressQuantityDescription& quantity : live::stressQuantities()) {
    auto* name = new QLabel(inWords(quantity.name), this);
    name->setObjectName(QStringLiteral("muted"));
    auto* value = new QLabel(this);
    value->setObjectName(QStringLiteral("probe_%1").arg(text(quantity.id)));
    value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    grid->addWidget(name, row, 0);
    grid->addWidget(value, row++, 1);
    names_.push_back(name);
    values_.push_back(value);
  }
  grid->addWidget(makeActionButton(pin, this), row, 0, 1, 2);
  connect(&model, &StressModel::probeChanged, this, &ProbeCard::sync);
  connect(&model, &StressModel::activeChanged, this, &ProbeCard::sync);
  connect(&model, &StressModel::updated, this, &ProbeCard::sync);
  connect(&model, &StressModel::numbersChanged, this, &ProbeCard::sync);
  hide();
}

QString ProbeCard::placeInWords(const Vec3& place) {
  return text(presentation::formatPlace(place, decimalMark()));
}

void ProbeCard::sync() {
  const int point = model_.probe();
  const auto mesh = model_.live().mesh();
  const deformation::StressMap& map = model_.shownMap();
  const bool any = model_.active() && mesh && point >= 0 && point < map.volumeRatio.size();
  setVisible(any);
  if (!any)
    return;
  const Vec3 at = mesh->points.row(point);
  place_->setText(mesh->isWitness(point) ? tr("Witness point %1").arg(point)
                                         : tr("Surface point %1").arg(point));
  position_->setText(tr("At rest %1 mm").arg(placeInWords(at)));
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const live::StressQuantityDescription& quantity = live::stressQuantities()[i];
    // Each value over a cycle is an extreme of its own instant, and says so.
    names_[i]->setText(inWords(model_.peakShown() ? quantity.peakName : quantity.name));
    const live::StressMeasure measure(quantity.quantity, model_.look().material);
    names_[i]->setVisible(measure.known());
    values_[i]->setVisible(measure.known());
    const double value = live::quantityAt(map, measure, point);
    if (quantity.quantity == live::StressQuantity::folded)
      values_[i]->setText(value > 0 ? tr("yes") : tr("no"));
    else
      values_[i]->setText(
          quantity.unit.empty()
              ? formatNumber(value, quantity.decimals)
              : tr("%1 %2").arg(formatNumber(value, quantity.decimals)).arg(inWords(measure.shortUnit())));
  }
  adjustSize();
}

} // namespace viscera::app
