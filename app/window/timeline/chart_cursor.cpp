#include "window/timeline/chart_cursor.h"

#include <QEvent>
#include <QPainter>

#include <utility>

#include "signs/instant_marks.h"

namespace viscera::app {

ChartCursor::ChartCursor(QWidget& chart) : QWidget(&chart) {
  setObjectName(QStringLiteral("chartCursor"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  chart.installEventFilter(this);
  resize(chart.size());
}

void ChartCursor::setColor(const QColor& color) {
  color_ = color;
  update();
}

void ChartCursor::setMarks(Marks marks) {
  if (marks == marks_)
    return;
  const QRegion before = covered();
  marks_ = std::move(marks);
  update(before + covered());
}

bool ChartCursor::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize)
    resize(parentWidget()->size());
  return QWidget::eventFilter(watched, event);
}

QRegion ChartCursor::covered() const {
  QRegion region;
  const auto add = [&region](const QRectF& box) {
    constexpr int kAround = 2; // Smoothed edges, and the ring's pen.
    region += box.toAlignedRect().adjusted(-kAround, -kAround, kAround, kAround);
  };
  for (const Line& line : marks_.lines)
    add(boxOf(line, size()));
  for (const Ring& ring : marks_.rings)
    add(boxOf(ring, size()));
  return region;
}

void ChartCursor::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  paintMarks(painter, marks_, size(), color_);
}

} // namespace viscera::app
