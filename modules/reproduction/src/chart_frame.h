#pragma once

#include <string>
#include <vector>

#include "svg_canvas.h"

namespace viscera::reproduction {

/// Numbers from `low` to `high` on a picture.
struct Axis {
  std::string label; ///< With its unit: "place along the line, mm".
  double low = 0;
  double high = 1;
  bool logarithmic = false;
};

/// Round numbers within the axis, about `wanted` of them; on a logarithmic one powers of ten.
std::vector<double> ticksOf(const Axis& axis, int wanted);

/// An axis that holds all values with a little room, its ends at round numbers.
Axis axisAround(std::string label, double low, double high);

/// The part of a picture inside the axes: turns numbers into places, and draws grid, ticks and labels.
class ChartFrame {
public:
  ChartFrame(SvgCanvas& canvas, Place corner, double width, double height, Axis x, Axis y);

  Place at(double x, double y) const;
  /// Grid, frame, ticks with numbers and both labels. `xNumbers` is false where bars are named instead.
  void draw(bool xNumbers = true);

  const Place& corner() const { return corner_; }
  double width() const { return width_; }
  double height() const { return height_; }

private:
  SvgCanvas& canvas_;
  Place corner_;
  double width_;
  double height_;
  Axis x_;
  Axis y_;
};

/// The colours of Okabe and Ito, which people with any colour vision tell apart; without its yellow, which is
/// too light for lines.
const std::vector<std::string>& palette();

/// A pen for curve or bar `index`: colour after colour, then the same ones dashed, then dotted.
Pen penFor(std::size_t index);

} // namespace viscera::reproduction
