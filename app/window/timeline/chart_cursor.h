#pragma once

#include <QColor>
#include <QWidget>

#include "viscera/scene/curve_panels.h"

namespace viscera::app {

/// Draws the present instant over a chart, as upright lines and rings, in a widget of its own: it must follow
/// every frame, and rendering the chart anew would take as long as rendering the organs.
class ChartCursor final : public QWidget {
  Q_OBJECT

public:
  using Marks = scene::InstantMarks;
  using Line = Marks::Line;
  using Ring = Marks::Ring;

  /// Covers `chart`, its parent; the mouse reaches what is below.
  explicit ChartCursor(QWidget& chart);

  void setColor(const QColor& color);
  void setMarks(Marks marks);
  const Marks& marks() const { return marks_; }

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  /// The region to repaint when the marks change.
  QRegion covered() const;

  QColor color_;
  Marks marks_;
};

} // namespace viscera::app
