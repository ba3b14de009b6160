#include "window/stress/histogram.h"

#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <cmath>

#include "viscera/scene/legend.h"

namespace viscera::app {
namespace {
constexpr int kBars = 48;
constexpr int kHistogramHeight = 92;
constexpr int kLabelGap = 3;
constexpr int kMostTicks = 5;
} // namespace

Histogram::Histogram(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("stressHistogram"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setMinimumHeight(kHistogramHeight);
  setAccessibleName(tr("Histogram of the map"));
  setToolTip(tr("Number of witness points with each value; the lines mark the mean and the 95th percentile"));
}

void Histogram::show(const Values& values, Eigen::Index count, const Contents& contents) {
  contents_ = contents;
  bars_.assign(kBars, 0);
  for (Eigen::Index i = 0; i < count; ++i)
    if (std::isfinite(values[i])) {
      const double bar = std::clamp(kBars * scene::partOf(contents.range, values[i]), 0.0, kBars - 1.0);
      ++bars_[static_cast<std::size_t>(bar)];
    }
  update();
}

void Histogram::clear() {
  bars_.clear();
  update();
}

double Histogram::xOf(double value) const {
  return std::clamp(scene::partOf(contents_.range, value), 0.0, 1.0) * (width() - 1);
}

void Histogram::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const int base = height() - fontMetrics().height() - kLabelGap;
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawLine(0, base, width(), base);
  if (bars_.empty())
    return;
  const int most = std::max(1, *std::max_element(bars_.begin(), bars_.end()));
  for (int bar = 0; bar < kBars; ++bar) {
    const double value = scene::valueAt(contents_.range, (bar + 0.5) / kBars);
    const auto row = contents_.colors.colors.row((contents_.colors.colors.rows() - 1) * bar / (kBars - 1));
    QColor color(row[0], row[1], row[2]);
    if (value < contents_.shown.low || value > contents_.shown.high)
      color.setAlphaF(0.22);
    // The square root keeps the few points of the tail in sight; they are what one looks for.
    const double tall = std::sqrt(double(bars_[std::size_t(bar)]) / most) * (base - 4);
    const QRectF box(double(bar) * width() / kBars, base - tall, double(width()) / kBars - 0.6, tall);
    painter.fillRect(box, color);
  }
  const QColor ink = palette().color(QPalette::WindowText);
  painter.setPen(QPen(ink, 1.2));
  painter.drawLine(QPointF(xOf(contents_.mean), 2), QPointF(xOf(contents_.mean), base));
  painter.setPen(QPen(ink, 1.2, Qt::DotLine));
  painter.drawLine(QPointF(xOf(contents_.percentile95), 2), QPointF(xOf(contents_.percentile95), base));
  painter.setPen(ink);
  const auto ticks = scene::niceTicks(contents_.range, kMostTicks);
  const auto labels = scene::tickLabels(ticks);
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const QString label =
        QString::fromStdString(labels[i]).replace(QLatin1Char('.'), QLocale().decimalPoint());
    const double half = 0.5 * fontMetrics().horizontalAdvance(label);
    const double x = std::clamp(xOf(ticks[i]) - half, 0.0, std::max(0.0, width() - 2 * half));
    painter.drawText(QPointF(x, height() - fontMetrics().descent()), label);
  }
}

} // namespace viscera::app
