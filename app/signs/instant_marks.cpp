#include "signs/instant_marks.h"

#include <QPainter>

namespace viscera::app {
namespace {
constexpr double kCursorWidth = 1.5; ///< Logical pixels.
constexpr double kRingSize = 9;

QColor markColor(const QColor& color) {
  constexpr double kMarkOpacity = 0.8;
  QColor seen = color;
  seen.setAlphaF(kMarkOpacity);
  return seen;
}
} // namespace

QRectF boxOf(const scene::InstantMarks::Line& line, const QSizeF& chart) {
  return {line.x * chart.width() - kCursorWidth / 2, (1 - line.high) * chart.height(), kCursorWidth,
          (line.high - line.low) * chart.height()};
}

QRectF boxOf(const scene::InstantMarks::Ring& ring, const QSizeF& chart) {
  return {ring.x * chart.width() - kRingSize / 2, (1 - ring.y) * chart.height() - kRingSize / 2, kRingSize,
          kRingSize};
}

void paintMarks(QPainter& painter, const scene::InstantMarks& marks, const QSizeF& chart,
                const QColor& color) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  for (const scene::InstantMarks::Line& line : marks.lines)
    painter.fillRect(boxOf(line, chart), markColor(color));
  painter.setPen(QPen(markColor(color), kCursorWidth));
  for (const scene::InstantMarks::Ring& ring : marks.rings)
    painter.drawEllipse(boxOf(ring, chart));
}

} // namespace viscera::app
