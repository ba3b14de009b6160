#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "viscera/coordinates/measure/line_profile.h"
#include "viscera/thesis/item.h"

/// Figures of the thesis that show coordinates along a line among handles.
namespace viscera::thesis {

/// The expected property of a panel's coordinates.
enum class Expect {
  everywhere,    ///< Coordinates at every point.
  positive,      ///< None below 0.
  negative,      ///< Some below 0.
  continuous,    ///< None jumps.
  jumps,         ///< Some jump.
  smooth,        ///< Continuous, and no slope jumps.
  kinks,         ///< Continuous, and slopes jump.
  severalMaxima, ///< One coordinate has more than one, inside the line.
};

using Choices = std::vector<std::pair<std::string, std::string>>;

/// One plot of a figure.
struct Panel {
  std::string name;   ///< "target 1/d"
  std::string system; ///< Its id.
  Choices choices;    ///< Parameters, by name.
  int handles = 15;   ///< Around the line, one of `kLineHandles`.
  std::vector<Expect> expected;
  bool sword = false;       ///< The line sags through a point that is in line with two handles.
  bool profileOnly = false; ///< No search for jumps and kinks, and fewer points: for what takes very long.
};

/// A panel measured.
struct PanelResult {
  coordinates::LineProperties properties;
  coordinates::LineProfile profile;
};

/// The profile with rows that are not numbers where there are no coordinates.
Eigen::MatrixXd coordinatesWithGaps(const PanelResult& result);

/// A figure made of panels.
struct LineFigure {
  std::string id;
  std::string title;
  std::string claim;
  std::string setup;
  std::vector<Panel> panels;
  /// Findings that compare panels; may be empty.
  std::function<std::vector<Finding>(const std::vector<PanelResult>&)> compare = {};
};

/// A sentence about the source of the handles of such figures, for their `setup`.
inline const std::string kOwnHandles = "The thesis prints no positions of handles; ours are the tables of "
                                       "resources/lines, a long box with handles "
                                       "wound around the line inside it. ";

/// The item that measures and draws a figure.
Item itemOf(const LineFigure& figure);

} // namespace viscera::thesis
