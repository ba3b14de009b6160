#include "window/circulation/numbers_table.h"

#include <QFontMetrics>
#include <QHeaderView>
#include <QStyle>
#include <QStyledItemDelegate>

#include <algorithm>
#include <cmath>

#include "window/style/language.h"
#include "window/work/workspace.h"

namespace viscera::app {
namespace {

enum NumbersColumn { kNumbersName, kNumbersNow, kNumbersBefore, kNumbersNormal, kNumbersColumns };
constexpr int kNumbersRowHeight = 20;

const circulation::Reading& readingOf(int row) {
  return circulation::readings()[static_cast<std::size_t>(row)];
}

/// Names of one vessel differ behind their comma ("Aorta, systolic"), and two vessels before it: if there is
/// no room, the unit is left out first, then both parts are shortened.
QString readingName(const QString& name, const QString& unit, const QFontMetrics& metrics, int room) {
  constexpr int kLeastShare = 3; // Of the room, for what is before the comma.
  for (const QString& whole : {name + unit, name})
    if (metrics.horizontalAdvance(whole) <= room)
      return whole;
  const int comma = name.lastIndexOf(QLatin1String(", "));
  if (comma < 0)
    return metrics.elidedText(name, Qt::ElideMiddle, room);
  const QString end = name.mid(comma);
  const int before = std::max(room - metrics.horizontalAdvance(end), room / kLeastShare);
  const QString vessel = metrics.elidedText(name.left(comma), Qt::ElideRight, before);
  return vessel + metrics.elidedText(end, Qt::ElideRight, room - metrics.horizontalAdvance(vessel));
}

/// Draws names of readings, whose units are with them as `Qt::UserRole`.
class ReadingNames final : public QStyledItemDelegate {
public:
  using QStyledItemDelegate::QStyledItemDelegate;

protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    if (!option->widget || option->rect.isEmpty())
      return;
    const QStyle* style = option->widget->style();
    const int margin = style->pixelMetric(QStyle::PM_FocusFrameHMargin, option, option->widget) + 1;
    const QRect place = style->subElementRect(QStyle::SE_ItemViewItemText, option, option->widget);
    const QString unit = index.data(Qt::UserRole).toString();
    const QString name = option->text.left(option->text.size() - unit.size());
    option->text = readingName(name, unit, option->fontMetrics, place.width() - 2 * margin - 1);
  }
};

} // namespace

QString sourceText(const circulation::NormalValues& normal) {
  QStringList parts;
  for (const Text& part : {normal.meaning, named(normal.people), named(normal.source)})
    if (!part.empty())
      parts.push_back(inWords(part));
  return parts.join(QStringLiteral("; "));
}

QString normalText(const circulation::NormalValues& normal, int decimals) {
  const QString low = formatNumber(normal.low, decimals), high = formatNumber(normal.high, decimals);
  if (!std::isfinite(normal.high))
    return NumbersTable::tr("from %1").arg(low);
  if (!std::isfinite(normal.low))
    return NumbersTable::tr("up to %1").arg(high);
  return QStringLiteral("%1\u2013%2").arg(low, high);
}

NumbersTable::NumbersTable(QWidget* parent)
    : QTableWidget(static_cast<int>(circulation::readings().size()), kNumbersColumns, parent),
      theme_(themeOf(ThemeKind::dark)) {
  setObjectName(QStringLiteral("circulationNumbers"));
  setAccessibleName(tr("Numbers of the circulation"));
  setHorizontalHeaderLabels({QString(), tr("now"), tr("before"), tr("normal")});
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionResizeMode(kNumbersName, QHeaderView::Stretch);
  horizontalHeader()->setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
  horizontalHeader()->setHighlightSections(false);
  horizontalHeader()->setMinimumSectionSize(kNumbersRowHeight);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(kNumbersRowHeight);
  setShowGrid(false);
  setEditTriggers(NoEditTriggers);
  setSelectionMode(NoSelection);
  setFocusPolicy(Qt::NoFocus);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setWordWrap(false);
  setItemDelegateForColumn(kNumbersName, new ReadingNames(this));
  for (int row = 0; row < rowCount(); ++row) {
    const circulation::Reading& reading = readingOf(row);
    const QString unit = reading.unit.empty() ? QString() : QStringLiteral(" (%1)").arg(text(reading.unit));
    auto* name = new QTableWidgetItem(inWords(reading.title) + unit);
    name->setData(Qt::UserRole, unit);
    name->setToolTip(name->text());
    setItem(row, kNumbersName, name);
    for (const int column : {kNumbersNow, kNumbersBefore, kNumbersNormal}) {
      auto* item = new QTableWidgetItem;
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      setItem(row, column, item);
    }
  }
  setPerson({});
  setIndices(nullptr, nullptr);
}

void NumbersTable::setPerson(const anatomy::Person& person) {
  person_ = person;
  for (int row = 0; row < rowCount(); ++row) {
    const auto normal = circulation::normalOf(readingOf(row), person);
    if (!normal)
      continue;
    item(row, kNumbersNormal)->setText(normalText(*normal, readingOf(row).decimals > 0 ? 1 : 0));
    item(row, kNumbersNormal)->setToolTip(sourceText(*normal));
  }
}

void NumbersTable::setIndices(const circulation::Indices* now, const circulation::Indices* before) {
  setColumnHidden(kNumbersBefore, !before);
  for (int row = 0; row < rowCount(); ++row) {
    fill(row, kNumbersNow, now);
    fill(row, kNumbersBefore, before);
  }
}

void NumbersTable::fill(int row, int column, const circulation::Indices* indices) {
  const circulation::Reading& reading = readingOf(row);
  const double value = indices ? reading.of(*indices) : 0;
  const auto normal = circulation::normalOf(reading, person_);
  const bool odd = indices && normal && !normal->holds(value);
  item(row, column)->setText(indices ? formatNumber(value, reading.decimals) : QStringLiteral("-"));
  item(row, column)->setForeground(odd ? theme_.warning : theme_.text);
}

void NumbersTable::setTheme(const Theme& theme) {
  theme_ = theme;
  for (int row = 0; row < rowCount(); ++row) {
    item(row, kNumbersName)->setForeground(theme.text);
    item(row, kNumbersNormal)->setForeground(theme.muted);
  }
}

} // namespace viscera::app
