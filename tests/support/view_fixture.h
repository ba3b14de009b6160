#pragma once

#include <array>
#include <memory>

#include <vtkInteractorObserver.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include "viscera/scene/organ_view.h"
#include "viscera/scene/surfaceless_window.h"
#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"
#include "viscera/scene/vtkVisceraHandleSetWidget.h"

/// A view in a window without a display, with simulated mouse and keyboard, for tests.
namespace viscera::tests {

struct ViewInWindow {
  explicit ViewInWindow(int width = 400, int height = 300, double pixelRatio = 1)
      : surface(width, height, pixelRatio) {
    view.setWindow(surface.window());
    view.setInteractor(surface.interactor());
  }

  void render() { surface.window()->Render(); }

  /// Where VTK's own matrices put a point: device pixels from the lower left corner, and depth.
  std::array<double, 3> display(const Vec3& point) {
    std::array<double, 3> at{};
    vtkInteractorObserver::ComputeWorldToDisplay(view.renderer(), point.x(), point.y(), point.z(), at.data());
    return at;
  }

  std::shared_ptr<scene::OrganActor> addOrgan(geometry::TriangleMesh mesh) {
    auto organ =
        std::make_shared<scene::OrganActor>(std::make_shared<const geometry::TriangleMesh>(std::move(mesh)));
    view.add(organ);
    return organ;
  }

  scene::SurfacelessWindow surface;
  scene::OrganView view;
};

/// Sends what a mouse and a keyboard would send.
class Mouse {
public:
  explicit Mouse(vtkRenderWindowInteractor* interactor) : interactor_(interactor) {}

  void move(double x, double y) {
    at_[0] = static_cast<int>(x + 0.5);
    at_[1] = static_cast<int>(y + 0.5);
    send(vtkCommand::MouseMoveEvent);
  }
  void press(bool shift = false, bool control = false) {
    send(vtkCommand::LeftButtonPressEvent, shift, control);
  }
  void release() { send(vtkCommand::LeftButtonReleaseEvent); }
  void click(double x, double y, bool shift = false, bool control = false) {
    move(x, y);
    press(shift, control);
    release();
  }
  void drag(double x0, double y0, double x1, double y1, int steps = 4) {
    move(x0, y0);
    press();
    for (int i = 1; i <= steps; ++i)
      move(x0 + (x1 - x0) * i / steps, y0 + (y1 - y0) * i / steps);
    release();
  }
  void key(const char* symbol) {
    interactor_->SetKeySym(symbol);
    interactor_->InvokeEvent(vtkCommand::KeyPressEvent);
    interactor_->SetKeySym(nullptr);
  }
  void leave() { interactor_->InvokeEvent(vtkCommand::LeaveEvent); }
  int x() const { return at_[0]; }
  int y() const { return at_[1]; }

private:
  void send(unsigned long event, bool shift = false, bool control = false) {
    interactor_->SetEventInformation(at_[0], at_[1], control, shift);
    interactor_->InvokeEvent(event);
  }
  vtkRenderWindowInteractor* interactor_;
  int at_[2] = {0, 0};
};

} // namespace viscera::tests
