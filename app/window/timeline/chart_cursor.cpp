#include "window/timeline/chart_cursor.h"

#include <QEvent>
#include <QPainter>

#include <utility>

namespace viscera::app {
namespace {
constexpr double kCursorWidth = 1.5; ///< Logical pixels.
constexpr double kRingSize = 9;

QRectF boxOf(const ChartCursor::Line& line, const QSizeF& chart) {
  return {line.x * chart.width() - kCursorWidth / 2, (1 - line.high) * chart.height(), kCursorWidth,
          (line.high - line.low) * chart.height()};
}

QRectF boxOf(const ChartCursor::Ring& ring, const QSizeF& chart) {
  return {ring.x * chart.width() - kRingSize / 2, (1 - ring.y) * chart.height() - kRingSize / 2, kRingSize,
          kRingSize};
}

QColor markColor(const QColor& color) {
  constexpr double kMarkOpacity = 0.8;
  QColor seen = color;
  seen.setAlphaF(kMarkOpacity);
  return seen;
}
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
  paint(painter, marks_, size(), color_);
}

void ChartCursor::paint(QPainter& painter, const Marks& marks, const QSizeF& chart, const QColor& color) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  for (const Line& line : marks.lines)
    painter.fillRect(boxOf(line, chart), markColor(color));
  painter.setPen(QPen(markColor(color), kCursorWidth));
  for (const Ring& ring : marks.rings)
    painter.drawEllipse(boxOf(ring, chart));
}

} // namespace viscera::app
