#include "window/organs/volume_column.h"

#include <QApplication>
#include <QColor>
#include <QFontMetrics>
#include <QPainter>
#include <QStyle>

#include <algorithm>
#include <utility>

namespace viscera::app {
namespace {

constexpr double kChangeSize = 0.85;
constexpr int kBetweenRows = 2;

QFont changeFont(const QFont& font) {
  QFont small = font;
  small.setPointSizeF(kChangeSize * font.pointSizeF());
  return small;
}

/// The room that Qt leaves beside the texts of items.
int besideText(const QStyle& style, const QWidget* widget) {
  return style.pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, widget) + 1;
}

} // namespace

int VolumeColumn::rowHeight(const QFont& font) {
  return QFontMetrics(font).height() + QFontMetrics(changeFont(font)).height() + kBetweenRows;
}

int VolumeColumn::textWidth(const QFont& font, const QString& volume, const QString& change) {
  return std::max(QFontMetrics(font).horizontalAdvance(volume),
                  QFontMetrics(changeFont(font)).horizontalAdvance(change));
}

void VolumeColumn::paint(QPainter* painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) const {
  const QString change = index.data(kChangeRole).toString();
  if (change.isEmpty())
    return QStyledItemDelegate::paint(painter, option, index);
  QStyleOptionViewItem item = option;
  initStyleOption(&item, index);
  const QString volume = std::exchange(item.text, QString());
  const QStyle* style = item.widget ? item.widget->style() : QApplication::style();
  style->drawControl(QStyle::CE_ItemViewItem, &item, painter, item.widget);
  const QFont small = changeFont(item.font);
  const int upper = QFontMetrics(item.font).height(), lower = QFontMetrics(small).height();
  const int beside = besideText(*style, item.widget);
  QRect line = option.rect.adjusted(beside, 0, -beside, 0);
  line.setTop(line.top() + (line.height() - upper - lower) / 2);
  line.setHeight(upper);
  // The column may be as narrow as the last numbers were for a frame: digits are not cut then.
  constexpr int kPlace = int(Qt::AlignRight) | int(Qt::AlignVCenter) | int(Qt::TextDontClip);
  painter->save();
  painter->setFont(item.font);
  painter->setPen(item.palette.color(QPalette::Text));
  painter->drawText(line, kPlace, volume);
  line.translate(0, upper);
  line.setHeight(lower);
  painter->setFont(small);
  painter->setPen(index.data(kChangeColorRole).value<QColor>());
  painter->drawText(line, kPlace, change);
  painter->restore();
}

QSize VolumeColumn::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const QSize plain = QStyledItemDelegate::sizeHint(option, index);
  const QStyle* style = option.widget ? option.widget->style() : QApplication::style();
  const QString change = index.data(kChangeRole).toString();
  const int wide = textWidth(option.font, index.data(Qt::DisplayRole).toString(), change);
  return {std::max(plain.width(), wide + 2 * besideText(*style, option.widget)), plain.height()};
}

} // namespace viscera::app
