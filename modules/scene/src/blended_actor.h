#pragma once

#include <vtkOpenGLActor.h>

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

/// Moves a prop of the renderer to the end of its list, so that it is drawn after the others. Nothing happens
/// when it is not there.
void drawLast(vtkRenderer* renderer, vtkProp* prop);

} // namespace viscera::scene
