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

/// A chart with its axes and curves, and its place in a window.
struct CurvePanel {
  std::string title; ///< Above it; may be empty.
  std::string xTitle;
  std::string yTitle;
  std::vector<PanelCurve> curves;
  /// Where its axes cross and where they end, as parts of the window from its lower left; labels lie outside.
  double left = 0.1, bottom = 0.1, right = 0.95, top = 0.95;
  std::optional<ValueRange> xRange; ///< Else that of the curves.
  std::optional<ValueRange> yRange; ///< Else that of the curves with some room.
  bool xLabels = true;              ///< False: another panel below has them.
  bool yLabels = true;
  int mostXTicks = 6; ///< Of a small panel fewer, so that labels do not run into each other.
  int mostYTicks = 6;
  bool legend = false;
  bool cursor = false; ///< Whether its x is the time on which the present instant is marked over it.
};

/// Draws several charts in one window, for curves that are known as a whole: those of one cycle over time,
/// loops of two quantities. Draws into any vtkRenderWindow, which it has for itself; nothing is drawn until
/// the window is rendered. Belongs to the thread that renders.
class CurvePanels {
public:
  CurvePanels();
  ~CurvePanels();
  CurvePanels(const CurvePanels&) = delete;
  CurvePanels& operator=(const CurvePanels&) = delete;

  /// Draws in `window`. Null leaves the present one.
  void setWindow(vtkRenderWindow* window);
  void setTheme(const Theme& theme);
  /// What numbers have before their decimals, a point at first: ',' in German. Before `setPanels`.
  void setDecimalMark(char mark);
  /// Replaces all panels. Throws `UsageError` when a curve has not as many x as y. O(points); some ms.
  void setPanels(std::vector<CurvePanel> panels);

  /// Fits the panels into the window as large as it is now; called by the caller before it renders.
  void update();

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace viscera::scene
