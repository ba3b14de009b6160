#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/scene/color_map.h"
#include "viscera/scene/theme.h"

class vtkRenderWindow;
class vtkRenderWindowInteractor;

namespace viscera::scene {

/// A pale band behind the curves of a chart that shows a normal range.
struct ChartBand {
  ValueRange range;  ///< In the unit of the axis.
  std::string label; ///< Written into the stripe where no curve passes, if there is room; may be empty.
};

/// Name, colour and style of a curve.
struct ChartLine {
  std::string name;                  ///< "LV"
  Vec3 color = {0.3, 0.7, 0.75};     ///< Red green blue, 0 to 1.
  std::vector<ChartBand> bands = {}; ///< Drawn in the curve's colour, against its axis.
  bool rightAxis = false;            ///< Drawn against the axis at the right, which has a range of its own.
  bool dashed = false;               ///< For the same organ in a second view.
  bool dots = false;                 ///< Its points alone, without a line: what was measured.
};

/// Draws a chart of curves over time that grow while a sequence plays: volumes in ml, usually. Names stand at
/// the right ends of the curves, in their colours, and never over each other. It draws into any
/// vtkRenderWindow, which it uses alone. Nothing is drawn until the window is rendered: the caller decides
/// how often (some 10 Hz is enough; a frame costs about 30 ms in software). Belongs to the thread that
/// renders.
class VolumeChart {
public:
  VolumeChart();
  ~VolumeChart();
  VolumeChart(const VolumeChart&) = delete;
  VolumeChart& operator=(const VolumeChart&) = delete;

  /// Draws in `window`; null: detaches from the present one.
  void setWindow(vtkRenderWindow* window);
  void setTheme(const Theme& theme);
  /// Sets the decimal mark of numbers, a point by default: ',' in German.
  void setDecimalMark(char mark);
  /// "Time", "s", "Volume", "ml".
  void setAxes(const std::string& xTitle, const std::string& xUnit, const std::string& yTitle,
               const std::string& yUnit);

  /// Starts over with these curves, all empty.
  void setLines(const std::vector<ChartLine>& lines);
  /// Replaces the bands of a curve; its points stay.
  void setBands(int line, std::vector<ChartBand> bands);
  int lineCount() const;

  /// Adds one point to every curve; `values` has one number a curve (not a number: a gap). Times that go back
  /// drop what came after them: a sequence that starts again. Amortised O(lines).
  void append(double seconds, const Values& values);
  void clear();
  /// Replaces the points of one curve: `values[i]` at `times[i]`, ascending. `clear` removes them again.
  /// Throws `UsageError` when there are not as many of both.
  void setCurve(int line, std::vector<double> times, std::vector<double> values);
  int pointCount() const;

  /// How much of the past is kept and shown, s; older points are dropped. Default 10.
  void setTimeSpan(double seconds);
  /// A fixed time axis, for a cycle that is known as a whole; `append` then drops nothing.
  void setTimeRange(ValueRange seconds);

  /// A vertical line at a time, s.
  void setCursor(double seconds);
  void hideCursor();
  /// An upright line in the window: `x` is a part of its width from the left, `low` and `high` are parts of
  /// its height from below.
  struct Upright {
    double x = 0;
    double low = 0;
    double high = 1;
  };
  /// Where `setCursor` would draw a line, in the window as it was rendered last: for code that draws the
  /// cursor over the picture in every frame of a sequence instead of rendering the chart. Empty before the
  /// first picture, and for a time beyond the axis. O(1).
  std::optional<Upright> placeOf(double seconds) const;

  /// Updates the axes to the points. Call it before rendering. O(points).
  void update();

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace viscera::scene
