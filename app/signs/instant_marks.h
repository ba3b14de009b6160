#pragma once

#include <QColor>
#include <QRectF>
#include <QSizeF>

#include "viscera/scene/curve_panels.h"

class QPainter;

namespace viscera::app {

/// The pixels of a mark over a chart of that size, without the pen of a ring.
QRectF boxOf(const scene::InstantMarks::Line& line, const QSizeF& chart);
QRectF boxOf(const scene::InstantMarks::Ring& ring, const QSizeF& chart);

/// Draws the present instant over a chart of that size: upright lines and rings. On any thread.
void paintMarks(QPainter& painter, const scene::InstantMarks& marks, const QSizeF& chart,
                const QColor& color);

} // namespace viscera::app
