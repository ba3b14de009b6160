#include "window/widgets/system_combo.h"

#include <QHelpEvent>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QStyleOptionComboBox>
#include <QStylePainter>
#include <QToolTip>

#include <algorithm>
#include <utility>

#include "window/style/language.h"

namespace viscera::app {
namespace {

/// What a system is for, in the order of the list.
enum Kind { kRecommended, kWithCage, kWithTetrahedra, kAttempt, kKinds };

/// Recommended is what answers everywhere, without jumps and kinks, from the handles alone.
Kind kindOf(const coordinates::Traits& traits) {
  if (traits.needsCage)
    return kWithCage;
  if (traits.needsTetrahedra)
    return kWithTetrahedra;
  return traits.everywhere && traits.continuous && traits.smooth ? kRecommended : kAttempt;
}

QString headingOf(int kind) {
  switch (kind) {
  case kRecommended:
    return SystemCombo::tr("Recommended");
  case kWithCage:
    return SystemCombo::tr("With a cage");
  case kWithTetrahedra:
    return SystemCombo::tr("With tetrahedra");
  default:
    return SystemCombo::tr("Attempts of the thesis");
  }
}

} // namespace

SystemCombo::SystemCombo(const coordinates::Registry& registry, QWidget* parent) : QComboBox(parent) {
  setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  auto* model = new QStandardItemModel(this);
  for (int kind = 0; kind < kKinds; ++kind) {
    bool first = true;
    for (const coordinates::Registry::Entry& entry : registry.list()) {
      if (kindOf(entry.system->traits()) != kind)
        continue;
      if (std::exchange(first, false)) {
        auto* heading = new QStandardItem(headingOf(kind));
        heading->setFlags(Qt::NoItemFlags);
        QFont bold = font();
        bold.setBold(true);
        heading->setFont(bold);
        model->appendRow(heading);
      }
      auto* item = new QStandardItem(inWords(entry.system->name()));
      item->setData(QString::fromStdString(entry.system->id()), Qt::UserRole);
      item->setToolTip(inWords(entry.system->summary()));
      model->appendRow(item);
    }
  }
  setModel(model);
  setMaxVisibleItems(model->rowCount());
  connect(this, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
    if (const std::string id = systemAt(index); !id.empty())
      Q_EMIT systemChosen(id);
  });
}

std::string SystemCombo::systemAt(int index) const {
  return itemData(index).toString().toStdString();
}

void SystemCombo::setSystem(const std::string& id) {
  const QSignalBlocker quiet(this);
  setCurrentIndex(findData(QString::fromStdString(id)));
}

QString SystemCombo::shownText() const {
  constexpr int kBesideText = 2; // What the style leaves free within the field.
  QStyleOptionComboBox option;
  initStyleOption(&option);
  const QRect field =
      style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this);
  return fontMetrics().elidedText(currentText(), Qt::ElideRight, std::max(0, field.width() - kBesideText));
}

bool SystemCombo::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip || shownText() == currentText())
    return QComboBox::event(event);
  const QString whole = toolTip().isEmpty() ? currentText() : currentText() + QLatin1Char('\n') + toolTip();
  QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), whole, this);
  return true;
}

void SystemCombo::paintEvent(QPaintEvent*) {
  QStylePainter painter(this);
  painter.setPen(palette().color(QPalette::Text));
  QStyleOptionComboBox option;
  initStyleOption(&option);
  painter.drawComplexControl(QStyle::CC_ComboBox, option);
  option.currentText = shownText();
  painter.drawControl(QStyle::CE_ComboBoxLabel, option);
}

} // namespace viscera::app
