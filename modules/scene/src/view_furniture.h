#pragma once

#include "viscera/scene/theme.h"

#include "before_render.h"
#include "flat_shape.h"

class vtkRenderer;

/// The scale bar at the edge of a view, and the room that orientation cube and legend take there.
namespace viscera::scene {

/// Whether a view is narrow and higher than wide, like each of two views side by side: there is room above
/// and below an organ, but not beside it. Such a view has its legend along the upper edge and a small
/// orientation cube.
bool isNarrow(vtkRenderer* renderer, double typeScale);

/// The height of the legend at the upper edge of a narrow view: logical pixels, times the type scale.
inline constexpr double kLevelLegend = 62;
/// The same of one that has or had a mark below its numbers.
inline constexpr double kLevelMarkedLegend = 84;

/// The side of the corner at the lower left that is reserved for the orientation cube, device pixels.
double orientationCorner(vtkRenderer* renderer, double typeScale);

/// A line of a round number of millimetres at the bottom of a view, with the number above it; in a small
/// view, which organs fill, it lies at the lower edge and the number beside it. With a perspective camera it
/// is right in the plane of the camera's focal point.
class ScaleBar {
public:
  explicit ScaleBar(vtkRenderer* renderer);
  ~ScaleBar();

  void setTheme(const Theme& theme);
  void setShown(bool shown);
  /// Sets the decimal mark of numbers, a point by default.
  void setDecimalMark(char mark) { decimalMark_ = mark; }

private:
  void follow();
  void place(double left, double right, double bottom, double ratio);

  char decimalMark_ = '.';
  double typeScale_ = 1; ///< The bar grows with its type.

  FlatShape line_;
  vtkSmartPointer<vtkTextActor> text_;
  BeforeRender beforeRender_;
};

/// The longest length of 1, 2 or 5 times a power of ten that is at most `most` (> 0).
double roundLength(double most);

} // namespace viscera::scene
