#include "window/view/camera_link.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkRenderer.h>

namespace viscera::app {

CameraLink::CameraLink(ViewWidget& first, ViewWidget& second) : views_{&first, &second} {
  for (int view = 0; view < 2; ++view) {
    listeners_[view] = {this, view};
    commands_[view]->SetClientData(&listeners_[view]);
    commands_[view]->SetCallback([](vtkObject*, unsigned long, void* data, void*) {
      auto* listener = static_cast<Listener*>(data);
      listener->link->carry(listener->view);
    });
    // After a frame the camera is where it will stay for now.
    tags_[view] = views_[view]->view().renderer()->AddObserver(vtkCommand::EndEvent, commands_[view]);
  }
  carry(0);
}

CameraLink::~CameraLink() {
  for (int view = 0; view < 2; ++view)
    views_[view]->view().renderer()->RemoveObserver(tags_[view]);
}

void CameraLink::setOffset(const Vec3& offset) {
  offset_ = offset;
  known_[0] = {};
  carry(0);
}

CameraLink::Place CameraLink::placeOf(ViewWidget& view) {
  vtkCamera* camera = view.view().renderer()->GetActiveCamera();
  return {Vec3(camera->GetPosition()), Vec3(camera->GetFocalPoint()), Vec3(camera->GetViewUp()),
          camera->GetParallelScale()};
}

void CameraLink::carry(int from) {
  const Place place = placeOf(*views_[from]);
  if (place == known_[from])
    return;
  const int to = 1 - from;
  const Vec3 shift = from == 0 ? offset_ : Vec3(-offset_);
  const Vec3 position = place.position + shift;
  const Vec3 focus = place.focus + shift;
  vtkRenderer* renderer = views_[to]->view().renderer();
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(position.data());
  camera->SetFocalPoint(focus.data());
  camera->SetViewUp(place.up.data());
  camera->SetParallelScale(place.scale);
  renderer->ResetCameraClippingRange();
  known_[from] = place;
  known_[to] = placeOf(*views_[to]);
  views_[to]->scheduleRender();
}

} // namespace viscera::app
