#pragma once

#include <memory>

#include "viscera/core/arrays.h"
#include "viscera/scene/theme.h"

class vtkRenderer;

namespace viscera::scene {

/// A small ball of constant size on the screen at a place that is being looked at; seen faintly through what
/// lies in front of it. Belongs to the thread that renders.
class ProbeMarker {
public:
  ProbeMarker();
  ~ProbeMarker();
  ProbeMarker(const ProbeMarker&) = delete;
  ProbeMarker& operator=(const ProbeMarker&) = delete;

  /// Draws in `renderer` from now on. Null: nowhere.
  void setRenderer(vtkRenderer* renderer);
  void setTheme(const Theme& theme);

  void show(const Vec3& position);
  void hide();
  bool visible() const;
  Vec3 position() const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace viscera::scene
