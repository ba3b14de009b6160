#pragma once

#include <vector>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include "viscera/core/arrays.h"
#include "viscera/scene/theme.h"

#include "blended_actor.h"

class vtkFloatArray;
class vtkGlyph3DMapper;
class vtkPoints;
class vtkPolyData;
class vtkSphereSource;
class vtkUnsignedCharArray;
class vtkViewport;
class vtkWindow;

/// Draws handles as balls of constant size on the screen; parts behind an organ are seen through it, fainter.
namespace viscera::scene {

/// Position, size and colours of the ball that shows one handle.
struct HandleGlyph {
  Vec3 position = Vec3::Zero();
  double radius = 0;    ///< mm; 0 draws nothing.
  double rimRadius = 0; ///< mm, of the line around it; 0 draws none.
  Vec3 color = Vec3::Ones();
  Vec3 rimColor = Vec3::Ones();
  double ghost = 1; ///< Opacity where the ball is hidden, as a fraction of the largest one.
};

/// Draws the balls: their fronts, the lines around them (the back half of slightly larger balls), and as
/// ghosts the parts of them that are behind what has been drawn before.
class HandleGlyphs {
public:
  HandleGlyphs();
  ~HandleGlyphs();

  void set(const std::vector<HandleGlyph>& glyphs);
  int render(vtkViewport* viewport);
  void release(vtkWindow* window);
  vtkActor* actor() const { return actor_; }

private:
  /// Glyphs of one layer and their mapper.
  struct Layer {
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> radii;
    vtkNew<vtkUnsignedCharArray> colors;
    vtkNew<vtkPolyData> data;
    vtkNew<vtkGlyph3DMapper> mapper;
    explicit Layer(vtkSphereSource* ball);
    ~Layer();
    void resize(vtkIdType count);
    void put(vtkIdType i, const Vec3& position, double radius, const Vec3& color, double opacity = 1);
    void changed();
  };

  vtkNew<vtkSphereSource> ball_;
  Layer balls_;
  Layer rims_;
  Layer ghosts_; ///< The same balls, each as opaque as its ghost is.
  Layer ghostRims_;
  vtkNew<vtkActor> actor_;
  vtkNew<vtkActor> rimActor_;
  vtkNew<BlendedActor> ghostActor_;
  vtkNew<BlendedActor> ghostRimActor_;
};

} // namespace viscera::scene
