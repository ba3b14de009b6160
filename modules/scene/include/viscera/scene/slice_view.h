#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "viscera/core/arrays.h"
#include "viscera/scene/theme.h"

class vtkRenderer;
class vtkRenderWindow;

namespace viscera::scene {

/// A polygonal line on a slice, such as a contour.
struct SliceLine {
  std::vector<Eigen::Vector2d> points; ///< In pixels of the picture; whole numbers are their centres.
  bool closed = false;                 ///< The last point is joined to the first.
  Vec3 color = Vec3::Ones();           ///< Red green blue, 0 to 1.
  bool thin = false;                   ///< Half as wide as the others (0.75 instead of 1.5 logical pixels).
};

/// A disc on a slice's picture: a handle, a point that is measured.
struct SliceMark {
  Eigen::Vector2d place; ///< In pixels of the picture.
  double radius = 0;     ///< Logical pixels.
  Vec3 color = Vec3::Ones();
  Vec3 rim = Vec3::Zero(); ///< The line around it.
  double rimWidth = 1;     ///< Logical pixels.
};

/// A text on a slice, placed beside a point and inside of the picture.
struct SliceText {
  Eigen::Vector2d place; ///< In pixels of the picture.
  std::string words;     ///< UTF-8; may have several lines.
  Vec3 color = Vec3::Ones();
  /// The measured area in pixels of the picture, which the text does not cover if there is room beside it.
  /// Empty: only `place` is kept free.
  Eigen::AlignedBox2d around = {};
};

/// The contents of a slice to be drawn: grey levels for each pixel of the window, and lines, marks and texts
/// over them.
struct SlicePicture {
  int width = 0;                  ///< Device pixels.
  int height = 0;                 ///< Device pixels.
  std::vector<std::uint8_t> grey; ///< `width * height`, row by row from the lower left.
  std::vector<SliceLine> lines;
  std::vector<SliceMark> marks;         ///< Over the lines.
  std::vector<SliceText> texts;         ///< Over the marks.
  std::optional<Eigen::Vector2d> cross; ///< Where the other slices cut this one, in pixels.
  std::array<std::string, 4> edges;     ///< The letters of the sides at the left, right, lower and upper
                                        ///< edge: "R".
  std::string title;                    ///< At the upper left: "Axial 120.0 mm".
  std::string note;                     ///< At the lower left: "L 40 W 400".
  double mmPerPixel = 0;                ///< For the scale bar; 0: there is none.
};

/// Draws one slice of a scan in a window: grey levels pixel by pixel, contours, crosshair, letters at the
/// edges, scale bar. Draws into any vtkRenderWindow, as `OrganView` does. The background is black in every
/// theme, as usual in radiology. Belongs to the thread that renders.
class SliceView {
public:
  SliceView();
  ~SliceView();
  SliceView(const SliceView&) = delete;
  SliceView& operator=(const SliceView&) = delete;

  /// Draws in `window`; null detaches from the present one. Detach before the window is destroyed.
  void setWindow(vtkRenderWindow* window);
  vtkRenderWindow* window() const;
  vtkRenderer* renderer() const;
  /// Sets the theme of crosshair and letters.
  void setTheme(const Theme& theme);
  /// Sets the decimal mark of the scale bar, a point by default. Call it before `show`.
  void setDecimalMark(char mark);

  /// Shows the picture from the next frame on. A picture of another size than the window lies at its lower
  /// left. O(pixels + points).
  void show(const SlicePicture& picture);
  /// Device pixels in a logical one, by the window.
  double pixelRatio() const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace viscera::scene
