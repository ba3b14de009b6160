#pragma once

#include <string>
#include <vector>

#include "chart_frame.h"

namespace viscera::reproduction {

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

} // namespace viscera::reproduction
