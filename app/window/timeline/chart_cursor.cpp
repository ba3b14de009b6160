#include "window/timeline/chart_cursor.h"

#include <QEvent>
#include <QPainter>

#include <utility>

namespace viscera::app {
namespace {
constexpr double kCursorWidth = 1.5; ///< Logical pixels.
constexpr double kRingSize = 9;
} // namespace

ChartCursor::ChartCursor(QWidget& chart) : QWidget(&chart) {
  setObjectName(QStringLiteral("chartCursor"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  chart.installEventFilter(this);
  resize(chart.size());
}

void ChartCursor::setColor(const QColor& color) {
  color_ = color;
  color_.setAlphaF(0.8);
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

QRectF ChartCursor::boxOf(const Line& line) const {
  return {line.x * width() - kCursorWidth / 2, (1 - line.high) * height(), kCursorWidth,
          (line.high - line.low) * height()};
}

QRectF ChartCursor::boxOf(const Ring& ring) const {
  return {ring.x * width() - kRingSize / 2, (1 - ring.y) * height() - kRingSize / 2, kRingSize, kRingSize};
}

QRegion ChartCursor::covered() const {
  QRegion region;
  const auto add = [&region](const QRectF& box) {
    constexpr int kAround = 2; // Smoothed edges, and the ring's pen.
    region += box.toAlignedRect().adjusted(-kAround, -kAround, kAround, kAround);
  };
  for (const Line& line : marks_.lines)
    add(boxOf(line));
  for (const Ring& ring : marks_.rings)
    add(boxOf(ring));
  return region;
}

void ChartCursor::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  for (const Line& line : marks_.lines)
    painter.fillRect(boxOf(line), color_);
  painter.setPen(QPen(color_, kCursorWidth));
  for (const Ring& ring : marks_.rings)
    painter.drawEllipse(boxOf(ring));
}

} // namespace viscera::app
