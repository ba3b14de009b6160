#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/scene/color_map.h"
#include "viscera/scene/theme.h"

class vtkRenderWindow;

namespace viscera::scene {

/// One sector of a bull's eye: a part of a ring around its middle.
struct BullsEyeSector {
  int ring = 0;                            ///< 0 is the outermost of the figure's rings.
  double fromDegrees = 0, toDegrees = 360; ///< Anticlockwise from the right.
  std::optional<double> value;             ///< Its colour and its text; none: it is grey.
  bool hatched = false;                    ///< Whether the value is not to be relied on.
};

/// A bull's eye: rings of sectors, one inside the other, each with the colour of its value.
struct BullsEyeFigure {
  std::string title;
  std::string unit; ///< Beside the scale of colours: "%".
  std::vector<BullsEyeSector> sectors;
  int rings = 4;
  ColorMap colors = diverging();
  ValueRange range{-30, 30};
  int decimals = 0;
  /// Words outside the circle: to the right, above, to the left, below.
  std::vector<std::string> sides;
  std::string note;  ///< Below the circle; or empty.
  int selected = -1; ///< Index of a sector that gets the accent's rim; -1: none.
};

/// Draws bull's eyes side by side in a window, which it uses alone; nothing is drawn until the window is
/// rendered. Belongs to the thread that renders.
class BullsEyes {
public:
  BullsEyes();
  ~BullsEyes();
  BullsEyes(const BullsEyes&) = delete;
  BullsEyes& operator=(const BullsEyes&) = delete;

  /// Draws in `window`; null: detaches from the present one.
  void setWindow(vtkRenderWindow* window);
  void setTheme(const Theme& theme);
  void setFigures(std::vector<BullsEyeFigure> figures);

  /// Fits the figures to the present size of the window. Call it before rendering.
  void update();

  /// A sector of one of the figures.
  struct Hit {
    std::size_t figure = 0;
    std::size_t sector = 0;
  };
  /// The sector at a place of the window (pixels from its lower left), as it was when `update` was called
  /// last; none beside the circles.
  std::optional<Hit> at(double x, double y) const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace viscera::scene
