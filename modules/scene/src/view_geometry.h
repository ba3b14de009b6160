#pragma once

#include "viscera/core/arrays.h"
#include "viscera/scene/surface_pick.h"

class vtkRenderer;

/// Converts between places in space and on the display.
namespace viscera::scene {

/// The screen density, in dots per inch, at which a logical pixel is one device pixel.
inline constexpr double kLogicalDpi = 72;

/// Where a point of the world is on the display.
struct DisplayPoint {
  double x = 0;     ///< Device pixels from the left of the window.
  double y = 0;     ///< Device pixels from the bottom of the window.
  double depth = 0; ///< mm in front of the eye, along the direction of sight; negative behind it.
};

/// The camera and viewport of a renderer as plain numbers: projects points and rays without VTK's matrices,
/// which depend on the clipping range.
struct ViewGeometry {
  Vec3 eye = Vec3::Zero();
  Vec3 right = Vec3::UnitX();   ///< Unit, to the right of the picture.
  Vec3 up = Vec3::UnitZ();      ///< Unit, to the top of the picture.
  Vec3 forward = Vec3::UnitY(); ///< Unit, the direction of sight.
  bool parallel = false;
  double halfHeight = 1; ///< Half of the picture's height: mm when parallel, else mm at a depth of 1 mm.
  double centerX = 0;    ///< Middle of the viewport, device pixels.
  double centerY = 0;
  double pixelHeight = 1; ///< Height of the viewport, device pixels.
  double pixelRatio = 1;  ///< Device pixels in a logical pixel.

  DisplayPoint project(const Vec3& point) const;
  /// The point at `depth` that is seen at a display position.
  Vec3 unproject(double x, double y, double depth) const;
  Ray ray(double x, double y) const;
  /// mm that a device pixel covers at a depth.
  double worldPerPixel(double depth) const;
  /// mm that a logical pixel covers at a place; 0 behind the eye of a perspective camera.
  double logicalPixel(const Vec3& place) const;
};

ViewGeometry viewGeometry(vtkRenderer* renderer);

} // namespace viscera::scene
