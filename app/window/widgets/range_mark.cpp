#include "window/widgets/range_mark.h"

#include <QPainter>
#include <QSlider>
#include <QStyle>

#include <algorithm>

namespace viscera::app {
namespace {

constexpr int kMarkHeight = 5;
constexpr int kThickness = 3;
constexpr double kNarrowestMark = 3;

} // namespace

RangeMark::RangeMark(const QSlider& slider, QWidget* parent) : QWidget(parent), slider_(slider) {
  setFixedHeight(kMarkHeight);
}

void RangeMark::setPart(double from, double to) {
  from_ = std::clamp(from, 0.0, 1.0);
  to_ = std::clamp(to, from_, 1.0);
  update();
}

/// The slider's grip keeps half its length from both ends.
void RangeMark::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const double inset = 0.5 * style()->pixelMetric(QStyle::PM_SliderLength, nullptr, &slider_);
  const double length = width() - 2 * inset;
  const QRectF part(inset + from_ * length, 0, std::max(kNarrowestMark, (to_ - from_) * length), kThickness);
  painter.fillRect(part, palette().color(QPalette::Highlight));
}

} // namespace viscera::app
