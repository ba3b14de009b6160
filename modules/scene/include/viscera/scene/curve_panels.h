#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/scene/color_map.h"
#include "viscera/scene/theme.h"

class vtkRenderWindow;

namespace viscera::scene {

/// A curve of a chart: `y[i]` over `x[i]`, in this order, so that it may return on itself as a loop does.
struct PanelCurve {
  std::string name; ///< In the legend; empty: not in it.
  Vec3 color = {0.3, 0.7, 0.75};
  std::vector<double> x;
  std::vector<double> y;
  float width = 2; ///< Pixels.
  bool dashed = false;
};

/// A named instant of a chart: a thin upright line.
struct PanelMark {
  double x = 0;
  std::string text; ///< Beside its upper end; may be empty.
};

/// A range of y that is shaded over the whole width of a chart.
struct PanelBand {
  ValueRange y;
  Vec3 color = {0.3, 0.7, 0.75};
};

/// A chart with its axes and curves, and its place in a window.
struct CurvePanel {
  std::string title; ///< Above it; may be empty.
  std::string xTitle;
  std::string yTitle;
  std::vector<PanelCurve> curves;
  std::vector<PanelMark> marks;
  std::vector<PanelBand> bands;
  /// Where its axes cross and where they end, as parts of the window from its lower left; labels lie outside.
  double left = 0.1, bottom = 0.1, right = 0.95, top = 0.95;
  std::optional<ValueRange> xRange; ///< None: the range of the curves.
  std::optional<ValueRange> yRange; ///< None: the range of the curves with some room.
  bool xLabels = true;              ///< False: another panel below has them.
  bool yLabels = true;
  int mostXTicks = 6; ///< Of a small panel fewer, so that labels do not run into each other.
  int mostYTicks = 6;
  bool legend = false;
  bool cursor = false; ///< Whether x is the time, on which a cursor marks the present instant.
};

/// The present instant over charts: upright lines, and rings on loops. Places are parts of the window's width
/// and height, from its lower left.
struct InstantMarks {
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
  std::vector<Line> lines;
  std::vector<Ring> rings;
  bool operator==(const InstantMarks&) const = default;
};

/// Draws several charts of complete curves in one window: curves over one cycle, loops of two quantities. It
/// draws into any vtkRenderWindow, which it uses alone; nothing is drawn until the window is rendered.
/// Belongs to the thread that renders.
class CurvePanels {
public:
  CurvePanels();
  ~CurvePanels();
  CurvePanels(const CurvePanels&) = delete;
  CurvePanels& operator=(const CurvePanels&) = delete;

  /// Draws in `window`; null: detaches from the present one.
  void setWindow(vtkRenderWindow* window);
  /// Type and lines grow with the theme's scale of type.
  void setTheme(const Theme& theme);
  /// Sets the decimal mark of numbers, a point by default: ',' in German. Call it before `setPanels`.
  void setDecimalMark(char mark);
  /// Replaces all panels. Throws `UsageError` when a curve has not as many x as y. O(points); some ms.
  void setPanels(std::vector<CurvePanel> panels);

  /// Fits the panels to the present size of the window. Call it before rendering.
  void update();

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace viscera::scene
