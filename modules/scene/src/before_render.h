#pragma once

#include <functional>
#include <span>

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
  /// The same, and takes these actors along.
  void setRenderer(vtkRenderer* renderer, std::span<vtkProp* const> actors);
  vtkRenderer* renderer() const;

private:
  std::function<void()> call_;
  vtkNew<vtkCallbackCommand> command_;
  vtkWeakPointer<vtkRenderer> renderer_;
  unsigned long tag_ = 0;
};

} // namespace viscera::scene
