#pragma once

#include <array>

#include <vtkNew.h>

#include "viscera/core/arrays.h"
#include "window/view/view_widget.h"

class vtkCallbackCommand;

namespace viscera::app {

/// Links the cameras of two views, so that they have the same direction and scale: a change of one is applied
/// to the other.
class CameraLink final {
public:
  /// Moves the second camera to the place of the first one. Both views have to outlive the link.
  CameraLink(ViewWidget& first, ViewWidget& second);
  ~CameraLink();
  CameraLink(const CameraLink&) = delete;
  CameraLink& operator=(const CameraLink&) = delete;

  /// Sets the vector from the first view's organs to the second view's, mm.
  void setOffset(const Vec3& offset);

private:
  /// The linked properties of a camera.
  struct Place {
    Vec3 position = Vec3::Zero();
    Vec3 focus = Vec3::Zero();
    Vec3 up = Vec3::Zero();
    double scale = 0;
    bool operator==(const Place& other) const = default;
  };

  static Place placeOf(ViewWidget& view);
  void carry(int from);

  std::array<ViewWidget*, 2> views_;
  std::array<Place, 2> known_;
  Vec3 offset_ = Vec3::Zero();
  std::array<vtkNew<vtkCallbackCommand>, 2> commands_;
  std::array<unsigned long, 2> tags_{};
  struct Listener {
    CameraLink* link = nullptr;
    int view = 0;
  };
  std::array<Listener, 2> listeners_;
};

} // namespace viscera::app
