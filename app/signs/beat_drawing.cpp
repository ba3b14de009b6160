#include "signs/beat_drawing.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPolygonF>

#include <cmath>

#include "viscera/circulation/signs.h"

namespace viscera::app {
namespace {

// Logical pixels at scale 1.
constexpr double kAboveTracing = 2, kTracingHeight = 34, kBelowTracing = 4;
constexpr double kStripRowHeight = 14;
constexpr int kValves = 4;
constexpr double kBarHeight = 10;
constexpr double kLamp = 4;            ///< Radius.
constexpr double kNamesOfValves = 0.8; ///< Of the type.
constexpr double kBarOpacity = 0.3;
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

double xAt(const QRectF& area, double fraction) {
  return area.left() + fraction * area.width();
}

} // namespace

bool BeatDrawing::Valve::isOpen(double fraction) const {
  return opens < shuts ? fraction >= opens && fraction < shuts : fraction >= opens || fraction < shuts;
}

void BeatDrawing::setBeat(const std::optional<heart::CardiacBeat>& beat) {
  tracing_.clear();
  sounds_.clear();
  valves_.clear();
  if (!beat)
    return;
  const heart::VentricleClock &left = beat->left(), &right = beat->right();
  const double cycle = beat->times().cycle;
  tracing_ = tracingOf(*beat);
  const auto at = [cycle](double seconds) { return seconds / cycle - std::floor(seconds / cycle); };
  sounds_ = {{QCoreApplication::translate("viscera::app::BeatStrip", "S1"), at(left.inletShuts)},
             {QCoreApplication::translate("viscera::app::BeatStrip", "S2"), at(left.outletShuts)}};
  valves_ = {{QCoreApplication::translate("viscera::app::BeatStrip", "Mitral valve"), at(left.inletOpens),
              at(left.inletShuts)},
             {QCoreApplication::translate("viscera::app::BeatStrip", "Aortic valve"), at(left.outletOpens),
              at(left.outletShuts)},
             {QCoreApplication::translate("viscera::app::BeatStrip", "Tricuspid valve"), at(right.inletOpens),
              at(right.inletShuts)},
             {QCoreApplication::translate("viscera::app::BeatStrip", "Pulmonary valve"),
              at(right.outletOpens), at(right.outletShuts)}};
}

QStringList BeatDrawing::openValves(double fraction) const {
  QStringList open;
  for (const Valve& valve : valves_)
    if (valve.isOpen(fraction))
      open.push_back(valve.name);
  return open;
}

double BeatDrawing::height(double scale) const {
  if (!signs_.anyOfTextbook())
    return 0;
  double height = kAboveTracing + kBelowTracing;
  if (hasTracing())
    height += kTracingHeight;
  if (signs_.valves)
    height += kValves * kStripRowHeight;
  return scale * height;
}

void BeatDrawing::paint(QPainter& painter, const QRectF& area, double fraction, const Look& look) const {
  const double height = this->height(look.scale);
  if (!hasBeat() || height <= 0)
    return;
  painter.setRenderHint(QPainter::Antialiasing);
  QRectF rows = area.adjusted(kPhaseMargin, look.scale * kAboveTracing, -kPhaseMargin, 0);
  if (hasTracing()) {
    rows.setHeight(look.scale * kTracingHeight);
    paintTracing(painter, rows, look);
    rows.moveTop(rows.bottom());
  }
  rows.moveTop(rows.top() + look.scale * kBelowTracing);
  if (signs_.valves)
    paintValves(painter, rows, fraction, look);
  painter.setPen(QPen(look.ink, 1.5));
  painter.drawLine(QPointF(xAt(rows, fraction), area.top()),
                   QPointF(xAt(rows, fraction), area.top() + height));
}

void BeatDrawing::paintTracing(QPainter& painter, const QRectF& area, const Look& look) const {
  painter.setFont(look.type);
  painter.setPen(look.muted);
  const double ascent = painter.fontMetrics().ascent();
  for (const Sound& sound : sounds_) {
    if (!signs_.sounds)
      break;
    const double x = xAt(area, sound.at);
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    painter.drawText(QPointF(x + 4, area.top() + ascent - 2), sound.name);
  }
  if (!signs_.ecg)
    return;
  QPolygonF line;
  for (std::size_t i = 0; i < tracing_.size(); ++i) {
    const double high = (tracing_[i] - kLowestMv) / (kHighestMv - kLowestMv);
    line << QPointF(xAt(area, static_cast<double>(i) / kTracingSamples),
                    area.bottom() - high * area.height());
  }
  painter.setPen(QPen(look.ink, 1.2 * look.scale));
  painter.drawPolyline(line);
}

void BeatDrawing::paintValves(QPainter& painter, const QRectF& area, double fraction,
                              const Look& look) const {
  QFont small = look.type;
  small.setPointSizeF(kNamesOfValves * small.pointSizeF());
  painter.setFont(small);
  QColor bar = look.ink;
  bar.setAlphaF(kBarOpacity);
  const double lamp = look.scale * kLamp;
  double top = area.top();
  for (const Valve& valve : valves_) {
    const QRectF row(area.left(), top, area.width(), look.scale * kBarHeight);
    const auto fill = [&](double from, double to) {
      painter.fillRect(QRectF(xAt(row, from), row.top(), xAt(row, to) - xAt(row, from), row.height()), bar);
    };
    if (valve.opens < valve.shuts) {
      fill(valve.opens, valve.shuts);
    } else {
      fill(0, valve.shuts);
      fill(valve.opens, 1);
    }
    painter.setPen(QPen(look.ink, 1));
    painter.setBrush(valve.isOpen(fraction) ? look.ink : look.shut);
    painter.drawEllipse(QPointF(row.left() + lamp + 2, row.center().y()), lamp, lamp);
    painter.drawText(row.adjusted(3 * lamp + 4, -2 * look.scale, 0, 2 * look.scale),
                     Qt::AlignLeft | Qt::AlignVCenter, valve.name);
    top += look.scale * kStripRowHeight;
  }
}

} // namespace viscera::app
