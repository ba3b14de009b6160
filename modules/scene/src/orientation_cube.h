#pragma once

#include <array>
#include <optional>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>
#include <vtkUnsignedCharArray.h>

#include "viscera/scene/organ_view.h"
#include "viscera/scene/theme.h"

#include "before_render.h"

class vtkRenderer;

namespace viscera::scene {

/// The side of the corner at the lower left that is reserved for the orientation cube, in logical pixels,
/// times the theme's type scale; less in a narrow view (`orientationCorner`).
constexpr double kOrientationCorner = 104;

/// A small bevelled cube in the lower left corner, turned with the main camera. Its letters say where the
/// patient's anterior, posterior, left, right, superior and inferior sides are; they are upright in every
/// view, and the letter of a side that is seen edge-on is beside the cube. The side under the mouse can be
/// found and highlighted. The cube has a renderer of its own on the layer above.
class OrientationCube {
public:
  explicit OrientationCube(vtkRenderer* followed);
  ~OrientationCube();

  void setTheme(const Theme& theme);
  void setShown(bool shown);
  vtkRenderer* renderer() const { return renderer_; }

  /// The side whose face or letter is at a display position (device pixels from the lower left corner), as
  /// the last frame showed it; none beside the cube, or while it is hidden. A face on the cube's far side is
  /// not found.
  std::optional<StandardView> sideAt(double x, double y) const;
  void highlight(std::optional<StandardView> side);
  std::optional<StandardView> highlighted() const { return highlighted_; }

private:
  /// Where a side's letter stands, and how large.
  struct Letter {
    Vec3 place = Vec3::Zero();
    int size = 0; ///< Logical pixels; 0: the side looks away.
    bool onFace = true;
    double opacity = 1;
  };

  void follow();
  void paint();
  Letter letterOf(StandardView side, const Vec3& eye) const;
  void placeLetters();

  vtkRenderer* followed_;
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkPolyData> cube_;
  vtkNew<vtkUnsignedCharArray> colors_; ///< One a polygon of the cube: the six faces first.
  vtkNew<vtkActor> actor_;
  std::array<vtkSmartPointer<vtkTextActor>, 6> texts_;
  std::array<Letter, 6> letters_;
  std::optional<StandardView> highlighted_;
  Theme theme_ = darkTheme();
  double scale_ = 1; ///< Of the usual size, in the last frame.
  bool shown_ = true;
  BeforeRender beforeRender_;
};

} // namespace viscera::scene
