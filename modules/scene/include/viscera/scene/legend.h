#pragma once

#include <memory>
#include <string>
#include <vector>

#include "viscera/scene/color_map.h"
#include "viscera/scene/theme.h"

class vtkRenderer;

namespace viscera::scene {

/// The room that a legend takes along the edges of its view, device pixels.
struct LegendRoom {
  double above = 0;  ///< From the upper edge on, of a narrow view.
  double beside = 0; ///< From the right edge on, of any other.
};

/// The legend of a colour map: a bar of colours with title, unit and at most six ticks at round numbers, at
/// the right edge of a view, or along the upper edge of a narrow one that is higher than wide. Keeps its size
/// in logical pixels, times the theme's type scale, and follows the window's size and DPI. Belongs to the
/// thread that renders.
class Legend {
public:
  Legend();
  ~Legend();
  Legend(const Legend&) = delete;
  Legend& operator=(const Legend&) = delete;

  /// Draws in `renderer` from now on. Null: nowhere.
  void setRenderer(vtkRenderer* renderer);
  void setTheme(const Theme& theme);
  /// What numbers have before their decimals, a point at first: ',' in German. Before `show`.
  void setDecimalMark(char mark);

  /// What the colours mean: "Influence of H-7", unit "%" or empty.
  void show(const std::string& title, const std::string& unit, const ColorMap& map, ValueRange range);
  void hide();
  bool visible() const;
  /// What organs are to leave it; nothing while it is hidden. Once it has had a mark the room for it is kept
  /// until `hide`: tissue that folds in a part of a cycle must not move what is seen in each.
  LegendRoom room() const;
  /// The same of one that is or will be shown.
  LegendRoom roomWhenShown() const;

  /// A swatch below the bar for what has a colour of its own: "folded". Until `hide` or an empty label.
  void setMark(const std::string& label, const Vec3& color);

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Round numbers inside a range: at most `most` of them, ascending. They are 1, 2 or 5 times a power of ten
/// apart; on a logarithmic range they are the 1, 2 and 5 of every decade, or 1 and 3, or whole decades alone,
/// and evenly apart where it has less than a few of these.
std::vector<double> niceTicks(ValueRange range, int most = 6);

/// A tick's label with just the digits that tell it from its neighbours: "0.25", "-3", "1.2e-06".
/// `decimalMark` stands before the decimals.
std::string tickLabel(double value, double spacing, char decimalMark = '.');

/// A number that was written with a decimal point, with another decimal mark.
std::string withDecimalMark(std::string number, char decimalMark);

/// The labels of all ticks: evenly spaced ones have the same digits, those of decades each its own.
std::vector<std::string> tickLabels(const std::vector<double>& ticks, char decimalMark = '.');

} // namespace viscera::scene
