#pragma once

#include <functional>
#include <vector>

#include <vtkNew.h>
#include <vtkWeakPointer.h>

class vtkCallbackCommand;
class vtkProp;
class vtkRenderer;

namespace viscera::scene {

/// Calls a function before every frame of a renderer, for objects that depend on the camera or the window's
/// size.
class BeforeRender {
public:
  explicit BeforeRender(std::function<void()> call);
  ~BeforeRender();
  BeforeRender(const BeforeRender&) = delete;
  BeforeRender& operator=(const BeforeRender&) = delete;

  /// Sets the renderer; null: none. The renderer may be destroyed first.
  void setRenderer(vtkRenderer* renderer);
  /// The same, and moves these actors (such as a `std::array<vtkActor*, n>`) from the old renderer to the new
  /// one.
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
