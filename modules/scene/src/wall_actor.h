#pragma once

#include <vtkOpenGLActor.h>

namespace viscera::scene {

/// The actor of an organ. A renderer peels a translucent surface exactly: it draws it once for every layer,
/// which takes a software renderer a tenth of a second. This actor can do without, while something moves: it
/// is drawn with the opaque props, in their order, first its far walls (without order), then the nearest one
/// over them. What differs from peeling is the strength of walls between the nearest one and the far ones.
class WallActor : public vtkOpenGLActor {
public:
  static WallActor* New();
  vtkTypeMacro(WallActor, vtkOpenGLActor)

      /// Whether to do without peeling, where the surface is translucent at all. What this actor draws hides
      /// what is drawn after it: put it after all that is to be seen through it.
      void setDrawnWithoutPeeling(bool unpeeled);
  bool unpeeled() const { return unpeeled_; }

  void Render(vtkRenderer* renderer, vtkMapper* mapper) override;

private:
  bool unpeeled_ = false;
};

} // namespace viscera::scene
