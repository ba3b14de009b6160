#include "window/timeline/phase_scrubber.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace viscera::app {
namespace {
constexpr double kMargin = 8;
constexpr double kKeyStep = 0.01;
} // namespace

PhaseScrubber::PhaseScrubber(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Instant of the cycle"));
  setCursor(Qt::PointingHandCursor);
}

void PhaseScrubber::setPhases(std::vector<PhaseBand> phases) {
  phases_ = std::move(phases);
  update();
}

void PhaseScrubber::setFraction(double fraction) {
  fraction = std::clamp(fraction, 0.0, 1.0);
  if (fraction == fraction_)
    return;
  fraction_ = fraction;
  update();
}

QString PhaseScrubber::phaseName() const {
  const PhaseBand* phase = phaseAt(fraction_);
  return phase ? phase->name : QString();
}

QSize PhaseScrubber::sizeHint() const {
  return {400, fontMetrics().height() + 14};
}

QSize PhaseScrubber::minimumSizeHint() const {
  return {120, sizeHint().height()};
}

bool PhaseScrubber::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    auto* help = static_cast<QHelpEvent*>(event);
    const PhaseBand* phase = phaseAt(fractionAt(help->pos().x()));
    const QString keys = tr("Drag, or use the arrow keys");
    QToolTip::showText(help->globalPos(), phase ? tr("%1\n%2").arg(phase->name, keys) : keys, this);
    return true;
  }
  return QWidget::event(event);
}

void PhaseScrubber::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF area = strip();
  const QColor text = palette().color(QPalette::WindowText);
  const QColor accent = palette().color(QPalette::Highlight);
  QPainterPath outline;
  outline.addRoundedRect(area, 4, 4);
  painter.save();
  painter.setClipPath(outline);
  painter.fillRect(area, palette().color(QPalette::Base));
  paintPhases(painter, area);
  QColor passed = accent;
  passed.setAlphaF(0.25);
  painter.fillRect(QRectF(area.left(), area.top(), fraction_ * area.width(), area.height()), passed);
  painter.restore();
  painter.setPen(QPen(hasFocus() ? accent : palette().color(QPalette::Mid), 1));
  painter.drawPath(outline);
  const double x = area.left() + fraction_ * area.width();
  painter.setPen(QPen(text, 2, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(QPointF(x, area.top() - 2), QPointF(x, area.bottom() + 2));
  painter.setPen(Qt::NoPen);
  painter.setBrush(text);
  painter.drawEllipse(QPointF(x, area.top() - 1), 4, 4);
}

void PhaseScrubber::paintPhases(QPainter& painter, const QRectF& area) const {
  QColor band = palette().color(QPalette::WindowText);
  const QColor muted = palette().color(QPalette::PlaceholderText);
  bool shaded = false;
  for (const PhaseBand& phase : phases_) {
    const QRectF part(area.left() + phase.begin * area.width(), area.top(),
                      (phase.end - phase.begin) * area.width(), area.height());
    band.setAlphaF(shaded ? 0.05 : 0.11);
    painter.fillRect(part, band);
    shaded = !shaded;
    const bool present = &phase == phaseAt(fraction_);
    painter.setPen(present ? palette().color(QPalette::WindowText) : muted);
    const QRectF inner = part.adjusted(5, 0, -3, 0);
    if (painter.fontMetrics().horizontalAdvance(phase.name) <= inner.width())
      painter.drawText(inner, Qt::AlignVCenter | Qt::AlignLeft, phase.name);
  }
}

void PhaseScrubber::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton)
    scrubTo(fractionAt(event->x()));
}

void PhaseScrubber::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton)
    scrubTo(fractionAt(event->x()));
}

void PhaseScrubber::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
  case Qt::Key_Left:
    return scrubTo(fraction_ - kKeyStep);
  case Qt::Key_Right:
    return scrubTo(fraction_ + kKeyStep);
  case Qt::Key_Home:
    return scrubTo(0);
  case Qt::Key_End:
    return scrubTo(1);
  default:
    QWidget::keyPressEvent(event);
  }
}

QRectF PhaseScrubber::strip() const {
  return QRectF(rect()).adjusted(kMargin, 5, -kMargin, -3);
}

double PhaseScrubber::fractionAt(double x) const {
  const QRectF area = strip();
  return std::clamp((x - area.left()) / std::max(1.0, area.width()), 0.0, 1.0);
}

const PhaseBand* PhaseScrubber::phaseAt(double fraction) const {
  for (const PhaseBand& phase : phases_)
    if (fraction >= phase.begin && fraction < phase.end)
      return &phase;
  return phases_.empty() ? nullptr : &phases_.back();
}

void PhaseScrubber::scrubTo(double fraction) {
  setFraction(fraction);
  Q_EMIT scrubbed(fraction_);
}

} // namespace viscera::app
