#pragma once

#include <vtkOpenGLActor.h>

namespace viscera::scene {

/// The actor of an organ, which can draw a translucent wall without depth peeling. Peeling is exact, but
/// draws the surface once for every layer, which takes a software renderer a tenth of a second. While
/// something moves, this actor is instead drawn with the opaque props, in their order, first its far walls
/// (without order), then the nearest one over them. Compared with peeling, only the opacity of walls between
/// the nearest one and the far ones differs.
class WallActor : public vtkOpenGLActor {
public:
  static WallActor* New();
  vtkTypeMacro(WallActor, vtkOpenGLActor)

      /// Sets whether a translucent surface is drawn without peeling. This actor then hides everything that
      /// is drawn after it, so add it after all props that are to be seen through it.
      void setDrawnWithoutPeeling(bool unpeeled);
  bool unpeeled() const { return unpeeled_; }

  /// Sets whether anything is drawn. Unlike an invisible actor, one that is not drawn still has bounds.
  void setDrawn(bool drawn) { drawn_ = drawn; }
  bool drawn() const { return drawn_; }

  void Render(vtkRenderer* renderer, vtkMapper* mapper) override;
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderTranslucentPolygonalGeometry(vtkViewport* viewport) override;
  vtkTypeBool HasTranslucentPolygonalGeometry() override;

private:
  bool unpeeled_ = false;
  bool drawn_ = true;
};

} // namespace viscera::scene
