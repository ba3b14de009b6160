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
  /// In pixels of the picture: what is measured, and is not covered where there is room beside it. Empty:
  /// nothing but `place`.
  Eigen::AlignedBox2d around = {};
};

/// The contents of a slice to be drawn: grey levels for each pixel of the window, and what lies over them.
struct SlicePicture {
  int width = 0;                  ///< Device pixels.
  int height = 0;                 ///< Device pixels.
  std::vector<std::uint8_t> grey; ///< `width * height`, row by row from the lower left.
  std::vector<SliceLine> lines;
  std::vector<SliceMark> marks;         ///< Over the lines.
  std::vector<SliceText> texts;         ///< Over the marks.
  std::optional<Eigen::Vector2d> cross; ///< Where the other slices cut this one, in pixels.
  std::array<std::string, 4> edges;     ///< What lies to the left, right, below and above: "R".
  std::string title;                    ///< At the upper left: "Axial 120.0 mm".
  std::string note;                     ///< At the lower left: "L 40 W 400".
  double mmPerPixel = 0;                ///< For the scale bar; 0: there is none.
};

/// Draws one slice of a scan in a window: grey levels pixel by pixel, contours, crosshair, letters at the
/// edges, scale bar. Draws into any vtkRenderWindow, as `OrganView` does. The ground is black in every theme,
/// as radiologists have it. Belongs to the thread that renders.
class SliceView {
public:
  SliceView();
  ~SliceView();
  SliceView(const SliceView&) = delete;
  SliceView& operator=(const SliceView&) = delete;

  /// Draws in `window`; null leaves the present one, which has to be done before it is gone.
  void setWindow(vtkRenderWindow* window);
  vtkRenderWindow* window() const;
  vtkRenderer* renderer() const;
  /// For crosshair and letters.
  void setTheme(const Theme& theme);
  /// What the number of the scale bar has before its decimals, a point at first. Before `show`.
  void setDecimalMark(char mark);

  /// Shows this from the next frame on. A picture of another size than the window lies at its lower left.
  /// O(pixels + points).
  void show(const SlicePicture& picture);
  /// Device pixels in a logical one, by the window.
  double pixelRatio() const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace viscera::scene
