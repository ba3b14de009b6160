// GLEW has to come before any other OpenGL header.
#include <vtk_glew.h>

#include "blended_actor.h"

#include <vtkMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

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

void attach(vtkActor* actor, vtkPolyData* shape, vtkMatrix4x4* place) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(shape);
  actor->SetMapper(mapper);
  actor->SetUserMatrix(place);
  actor->PickableOff();
}

vtkSmartPointer<BlendedActor> newHelper(vtkPolyData* shape, vtkMatrix4x4* place, double opacity,
                                        bool behindOnly) {
  auto actor = vtkSmartPointer<BlendedActor>::New();
  attach(actor, shape, place);
  actor->setBehindOnly(behindOnly);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetOpacity(opacity);
  return actor;
}

void setColor(vtkActor* actor, const Vec3& color) {
  actor->GetProperty()->SetColor(color.x(), color.y(), color.z());
}

void placeAlong(vtkMatrix4x4* place, const Vec3& origin, const Vec3& axis, double scale) {
  const Vec3 side = axis.unitOrthogonal(), third = axis.cross(side);
  for (int row = 0; row < 3; ++row) {
    place->SetElement(row, 0, scale * axis[row]);
    place->SetElement(row, 1, scale * side[row]);
    place->SetElement(row, 2, scale * third[row]);
    place->SetElement(row, 3, origin[row]);
  }
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
