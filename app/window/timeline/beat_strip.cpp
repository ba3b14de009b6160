#include "window/timeline/beat_strip.h"

#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

#include "viscera/circulation/signs.h"
#include "window/timeline/phase_scrubber.h"

namespace viscera::app {
namespace {

constexpr double kTracingHeight = 34;
constexpr double kStripRowHeight = 14;
constexpr double kBarHeight = 10;
constexpr double kLamp = 4; ///< Radius.
constexpr int kTracingSamples = 400;
constexpr double kLowestMv = -0.4, kHighestMv = 1.2;

/// The electrocardiogram of a circulation at that rate whose atria contract when the textbook's do.
std::vector<double> tracingOf(const heart::CardiacBeat& beat) {
  circulation::Parameters parameters;
  parameters.rate = 60 / beat.times().cycle;
  parameters.conduction = beat.times().atrialSystole;
  std::vector<double> tracing;
  for (int i = 0; i <= kTracingSamples; ++i) {
    const double seconds = beat.times().cycle * i / kTracingSamples - beat.left().inletShuts;
    tracing.push_back(circulation::electrocardiogram(parameters, seconds));
  }
  return tracing;
}

} // namespace

bool BeatStrip::Valve::isOpen(double fraction) const {
  return opens < shuts ? fraction >= opens && fraction < shuts : fraction >= opens || fraction < shuts;
}

BeatStrip::BeatStrip(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Electrocardiogram, heart sounds and valves"));
  setToolTip(tr("Schematic electrocardiogram, heart sounds S1 and S2 when the valves close, and a bar for "
                "each valve while it is open. The lamp is lit while the valve is open."));
}

void BeatStrip::setBeat(const std::optional<heart::CardiacBeat>& beat) {
  tracing_.clear();
  sounds_.clear();
  valves_.clear();
  if (beat) {
    const heart::VentricleClock &left = beat->left(), &right = beat->right();
    const double cycle = beat->times().cycle;
    tracing_ = tracingOf(*beat);
    const auto at = [cycle](double seconds) { return seconds / cycle - std::floor(seconds / cycle); };
    sounds_ = {{tr("S1"), at(left.inletShuts)}, {tr("S2"), at(left.outletShuts)}};
    valves_ = {{tr("Mitral valve"), at(left.inletOpens), at(left.inletShuts)},
               {tr("Aortic valve"), at(left.outletOpens), at(left.outletShuts)},
               {tr("Tricuspid valve"), at(right.inletOpens), at(right.inletShuts)},
               {tr("Pulmonary valve"), at(right.outletOpens), at(right.outletShuts)}};
  }
  update();
}

void BeatStrip::setFraction(double fraction) {
  if (fraction == fraction_)
    return;
  fraction_ = fraction;
  update();
}

QStringList BeatStrip::openValves() const {
  QStringList open;
  for (const Valve& valve : valves_)
    if (valve.isOpen(fraction_))
      open.push_back(valve.name);
  return open;
}

QSize BeatStrip::sizeHint() const {
  return {400, static_cast<int>(kTracingHeight + 4 * kStripRowHeight + 6)};
}

QRectF BeatStrip::tracing() const {
  return {kPhaseMargin, 2, width() - 2 * kPhaseMargin, kTracingHeight};
}

double BeatStrip::xAt(double fraction) const {
  return tracing().left() + fraction * tracing().width();
}

void BeatStrip::paintEvent(QPaintEvent*) {
  if (valves_.empty())
    return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paintTracing(painter);
  paintValves(painter);
  painter.setPen(QPen(palette().color(QPalette::WindowText), 1.5));
  painter.drawLine(QPointF(xAt(fraction_), 0), QPointF(xAt(fraction_), height()));
}

void BeatStrip::paintTracing(QPainter& painter) const {
  const QRectF area = tracing();
  QPolygonF line;
  for (std::size_t i = 0; i < tracing_.size(); ++i) {
    const double high = (tracing_[i] - kLowestMv) / (kHighestMv - kLowestMv);
    line << QPointF(xAt(static_cast<double>(i) / kTracingSamples), area.bottom() - high * area.height());
  }
  const QColor muted = palette().color(QPalette::PlaceholderText);
  painter.setPen(muted);
  for (const Sound& sound : sounds_) {
    painter.drawLine(QPointF(xAt(sound.at), area.top()), QPointF(xAt(sound.at), area.bottom()));
    painter.drawText(QPointF(xAt(sound.at) + 4, area.top() + painter.fontMetrics().ascent() - 2), sound.name);
  }
  painter.setPen(QPen(palette().color(QPalette::WindowText), 1.2));
  painter.drawPolyline(line);
}

void BeatStrip::paintValves(QPainter& painter) const {
  QFont small = font();
  small.setPointSizeF(0.8 * small.pointSizeF());
  painter.setFont(small);
  QColor open = palette().color(QPalette::Highlight);
  double top = tracing().bottom() + 4;
  for (const Valve& valve : valves_) {
    const QRectF row(tracing().left(), top, tracing().width(), kBarHeight);
    QColor bar = open;
    bar.setAlphaF(0.4);
    const auto fill = [&](double from, double to) {
      painter.fillRect(QRectF(xAt(from), row.top(), xAt(to) - xAt(from), row.height()), bar);
    };
    if (valve.opens < valve.shuts) {
      fill(valve.opens, valve.shuts);
    } else {
      fill(0, valve.shuts);
      fill(valve.opens, 1);
    }
    painter.setPen(QPen(palette().color(QPalette::WindowText), 1));
    painter.setBrush(valve.isOpen(fraction_) ? QBrush(open) : QBrush(palette().color(QPalette::Base)));
    painter.drawEllipse(QPointF(row.left() + kLamp + 2, row.center().y()), kLamp, kLamp);
    painter.drawText(row.adjusted(3 * kLamp + 4, -2, 0, 2), Qt::AlignLeft | Qt::AlignVCenter, valve.name);
    top += kStripRowHeight;
  }
}

} // namespace viscera::app
