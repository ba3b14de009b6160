#include "before_render.h"

#include <utility>

#include <vtkCallbackCommand.h>
#include <vtkRenderer.h>

namespace viscera::scene {

BeforeRender::BeforeRender(std::function<void()> call) : call_(std::move(call)) {
  command_->SetClientData(this);
  command_->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*) { static_cast<BeforeRender*>(self)->call_(); });
}

BeforeRender::~BeforeRender() {
  setRenderer(nullptr);
}

void BeforeRender::setRenderer(vtkRenderer* renderer) {
  if (renderer_)
    renderer_->RemoveObserver(tag_);
  renderer_ = renderer;
  if (renderer_)
    tag_ = renderer_->AddObserver(vtkCommand::StartEvent, command_);
}

void BeforeRender::takeAlong(const std::vector<vtkProp*>& actors, vtkRenderer* renderer) const {
  for (vtkProp* actor : actors) {
    if (renderer_)
      renderer_->RemoveViewProp(actor);
    if (renderer)
      renderer->AddViewProp(actor);
  }
}

vtkRenderer* BeforeRender::renderer() const {
  return renderer_;
}

} // namespace viscera::scene
