#pragma once

#include <QColor>
#include <QWidget>

#include <vector>

namespace viscera::app {

/// Draws the present instant over a chart, as upright lines and rings, in a widget of its own: it must follow
/// every frame, and rendering the chart anew would take as long as rendering the organs. Places are fractions
/// of the chart's width and height, from its lower left.
class ChartCursor final : public QWidget {
  Q_OBJECT

public:
  struct Line {
    double x = 0;
    double low = 0;
    double high = 1;
    bool operator==(const Line&) const = default;
  };
  struct Ring {
    double x = 0;
    double y = 0;
    bool operator==(const Ring&) const = default;
  };
  struct Marks {
    std::vector<Line> lines;
    std::vector<Ring> rings;
    bool operator==(const Marks&) const = default;
  };

  /// Covers `chart`, its parent; the mouse reaches what is below.
  explicit ChartCursor(QWidget& chart);

  void setColor(const QColor& color);
  void setMarks(Marks marks);
  const Marks& marks() const { return marks_; }

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  QRectF boxOf(const Line& line) const;
  QRectF boxOf(const Ring& ring) const;
  /// The region to repaint when the marks change.
  QRegion covered() const;

  QColor color_;
  Marks marks_;
};

} // namespace viscera::app
