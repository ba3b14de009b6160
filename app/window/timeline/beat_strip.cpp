#include "window/timeline/beat_strip.h"

#include <QPainter>

#include <cmath>

namespace viscera::app {

BeatStrip::BeatStrip(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Electrocardiogram, heart sounds and valves"));
  setToolTip(tr("Schematic electrocardiogram, heart sounds S1 and S2 when the valves close, and a bar for "
                "each valve while it is open. The lamp is lit while the valve is open."));
}

void BeatStrip::setBeat(const std::optional<heart::CardiacBeat>& beat) {
  drawing_.setBeat(beat);
  update();
}

void BeatStrip::setSigns(const presentation::HeartSigns& signs) {
  if (signs == drawing_.signs())
    return;
  drawing_.setSigns(signs);
  updateGeometry();
  update();
}

void BeatStrip::setScale(double scale) {
  if (scale == scale_)
    return;
  scale_ = scale;
  updateGeometry();
  update();
}

void BeatStrip::setFraction(double fraction) {
  if (fraction == fraction_)
    return;
  fraction_ = fraction;
  update();
}

QSize BeatStrip::sizeHint() const {
  return {400, static_cast<int>(std::ceil(drawing_.height(scale_)))};
}

void BeatStrip::paintEvent(QPaintEvent*) {
  QFont type = font();
  type.setPointSizeF(scale_ * type.pointSizeF());
  QPainter painter(this);
  drawing_.paint(painter, rect(), fraction_,
                 {palette().color(QPalette::WindowText), palette().color(QPalette::PlaceholderText),
                  palette().color(QPalette::Base), type, scale_});
}

} // namespace viscera::app
