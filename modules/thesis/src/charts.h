#pragma once

#include <string>
#include <vector>

#include "svg_canvas.h"

namespace viscera::thesis {

/// An axis of a chart, from `low` to `high`.
struct Axis {
  std::string label; ///< With its unit: "place along the line, mm".
  double low = 0;
  double high = 1;
  bool logarithmic = false;
};

/// An axis that holds all values with a little room, its ends at round numbers.
Axis axisAround(std::string label, double low, double high);

/// A pen for curve or bar `index`: colour after colour, then the same ones dashed, then dotted.
Pen penFor(std::size_t index);

/// One curve of a chart; places that are not numbers are gaps.
struct Curve {
  std::string name; ///< In the legend; empty: not there.
  std::vector<double> x;
  std::vector<double> y;
  Pen pen;
};

/// Curves over numbers, with the legend beside them.
struct CurveChart {
  std::string title;
  Axis x;
  Axis y;
  std::vector<Curve> curves;

  std::string svg() const;
};

/// Bars side by side in named groups, each bar of a group belonging to one series.
struct BarChart {
  std::string title;
  Axis y;
  std::vector<std::string> series;
  struct Group {
    std::vector<std::string> name; ///< Lines below the group.
    std::vector<double> values;    ///< One a series; not a number: no bar.
  };
  std::vector<Group> groups;

  std::string svg() const;
};

} // namespace viscera::thesis
