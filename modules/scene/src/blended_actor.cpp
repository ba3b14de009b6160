// GLEW has to come before any other OpenGL header.
#include <vtk_glew.h>

#include "blended_actor.h"

#include <vtkMapper.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPropCollection.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace viscera::scene {

vtkStandardNewMacro(BlendedActor);

BlendedActor::BlendedActor() {
  ForceOpaqueOn();
  PickableOff();
}

void BlendedActor::Render(vtkRenderer* renderer, vtkMapper* mapper) {
  auto* state = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())->GetState();
  const vtkOpenGLState::ScopedglDepthMask keepMask(state);
  const vtkOpenGLState::ScopedglDepthFunc keepFunction(state);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglDepthFunc(behindOnly_ ? GL_GREATER : GL_LEQUAL);
  mapper->Render(renderer, this);
}

void drawLast(vtkRenderer* renderer, vtkProp* prop) {
  auto* props = renderer->GetViewProps();
  if (!props->IsItemPresent(prop) || props->GetLastProp() == prop)
    return;
  const vtkSmartPointer<vtkProp> keepAlive = prop;
  props->RemoveItem(prop);
  props->AddItem(prop);
}

} // namespace viscera::scene
