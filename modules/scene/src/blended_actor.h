#pragma once

#include <vtkOpenGLActor.h>
#include <vtkSmartPointer.h>

#include "viscera/core/arrays.h"

class vtkMatrix4x4;
class vtkPolyData;

namespace viscera::scene {

/// An actor for thin translucent helpers (ghosts, the allowed plane, outlines). It is drawn with the opaque
/// props, in their order, blended by its opacity and without writing depth: it costs no depth peeling and
/// hides nothing. Put it after the organs in the renderer's list (`drawLast`).
class BlendedActor : public vtkOpenGLActor {
public:
  static BlendedActor* New();
  vtkTypeMacro(BlendedActor, vtkOpenGLActor)

      /// Draws only what is behind what was drawn before, instead of what is in front of it.
      void setBehindOnly(bool behindOnly) {
    behindOnly_ = behindOnly;
  }

  void Render(vtkRenderer* renderer, vtkMapper* mapper) override;

protected:
  BlendedActor();

private:
  bool behindOnly_ = false;
};

/// Sets the shape of an actor and the matrix that places it (null: identity), and makes the actor unpickable.
void attach(vtkActor* actor, vtkPolyData* shape, vtkMatrix4x4* place);

/// The same for a new helper of one flat colour; `behindOnly` as in `BlendedActor`.
vtkSmartPointer<BlendedActor> newHelper(vtkPolyData* shape, vtkMatrix4x4* place, double opacity,
                                        bool behindOnly = false);

void setColor(vtkActor* actor, const Vec3& color);

/// Sets the matrix that places a shape made around the x axis along the unit `axis`, scaled, with its start
/// at `origin`.
void placeAlong(vtkMatrix4x4* place, const Vec3& origin, const Vec3& axis, double scale);

/// Moves a prop of the renderer to the end of its list, so that it is drawn after the others. Nothing happens
/// when it is not there.
void drawLast(vtkRenderer* renderer, vtkProp* prop);

} // namespace viscera::scene
