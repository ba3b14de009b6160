// GLEW has to come before any other OpenGL header.
#include <vtk_glew.h>

#include "wall_actor.h"

#include <vtkMapper.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace viscera::scene {

vtkStandardNewMacro(WallActor);

void WallActor::setDrawnWithoutPeeling(bool unpeeled) {
  unpeeled_ = unpeeled;
  // Not `SetForceOpaque`: that changes the time stamp, and with it shaders and buffers, at every frame.
  ForceOpaque = unpeeled;
}

int WallActor::RenderOpaqueGeometry(vtkViewport* viewport) {
  return drawn_ ? Superclass::RenderOpaqueGeometry(viewport) : 0;
}

int WallActor::RenderTranslucentPolygonalGeometry(vtkViewport* viewport) {
  return drawn_ ? Superclass::RenderTranslucentPolygonalGeometry(viewport) : 0;
}

vtkTypeBool WallActor::HasTranslucentPolygonalGeometry() {
  return drawn_ && Superclass::HasTranslucentPolygonalGeometry();
}

void WallActor::Render(vtkRenderer* renderer, vtkMapper* mapper) {
  if (!unpeeled_) {
    Superclass::Render(renderer, mapper);
    return;
  }
  auto* state = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())->GetState();
  const vtkOpenGLState::ScopedglDepthMask keepMask(state);
  const vtkOpenGLState::ScopedglColorMask keepColors(state);
  const vtkOpenGLState::ScopedglEnableDisable keepCulling(state, GL_CULL_FACE);
  const vtkOpenGLState::ScopedglDepthFunc keepFunction(state);
  state->vtkglEnable(GL_CULL_FACE);
  state->vtkglDepthFunc(GL_LEQUAL);

  state->vtkglCullFace(GL_FRONT); // The far walls, which hide nothing.
  state->vtkglDepthMask(GL_FALSE);
  mapper->Render(renderer, this);

  state->vtkglCullFace(GL_BACK); // How near the nearest wall is ...
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  mapper->Render(renderer, this);

  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE); // ... and that wall alone.
  mapper->Render(renderer, this);
}

} // namespace viscera::scene
