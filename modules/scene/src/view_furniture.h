#pragma once

#include "viscera/scene/theme.h"

#include "before_render.h"
#include "flat_shape.h"

class vtkRenderer;

/// What stands at an edge of every view.
namespace viscera::scene {

/// Whether a view is narrow and higher than wide, as each of two is: it has room above and below an organ,
/// and none beside it. There the legend lies along the upper edge and the orientation cube is small.
bool isNarrow(vtkRenderer* renderer, double typeScale);

/// What the legend of a narrow view takes from its upper edge on: logical pixels, times the type scale.
inline constexpr double kLevelLegend = 62;
/// The same of one that has or had a mark below its numbers.
inline constexpr double kLevelMarkedLegend = 84;

/// The side of the corner at the lower left that the orientation cube has for itself, device pixels.
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
  /// What numbers have before their decimals, a point at first.
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
