#pragma once

#include <functional>
#include <vector>

#include <vtkNew.h>
#include <vtkWeakPointer.h>

class vtkCallbackCommand;
class vtkProp;
class vtkRenderer;

namespace viscera::scene {

/// Calls a function every time before a renderer draws: for things that follow the camera or the window's
/// size.
class BeforeRender {
public:
  explicit BeforeRender(std::function<void()> call);
  ~BeforeRender();
  BeforeRender(const BeforeRender&) = delete;
  BeforeRender& operator=(const BeforeRender&) = delete;

  /// Null: nowhere. The renderer may die first.
  void setRenderer(vtkRenderer* renderer);
  /// The same, and takes these actors along (`std::array<vtkActor*, n>`, say).
  template <class Actors>
  void setRenderer(vtkRenderer* renderer, const Actors& actors) {
    const std::vector<vtkProp*> props(actors.begin(), actors.end());
    takeAlong(props, renderer);
    setRenderer(renderer);
  }
  vtkRenderer* renderer() const;

private:
  void takeAlong(const std::vector<vtkProp*>& actors, vtkRenderer* renderer) const;

  std::function<void()> call_;
  vtkNew<vtkCallbackCommand> command_;
  vtkWeakPointer<vtkRenderer> renderer_;
  unsigned long tag_ = 0;
};

} // namespace viscera::scene
