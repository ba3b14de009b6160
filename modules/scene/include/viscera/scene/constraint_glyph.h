#pragma once

#include <memory>

#include "viscera/core/arrays.h"
#include "viscera/scene/theme.h"

class vtkRenderer;

namespace viscera::scene {

/// Shows where a locked handle may go: the allowed plane as a translucent disc with a rim, and the gradient
/// that it is perpendicular to as an arrow. Sizes follow the zoom. Belongs to the thread that renders.
class ConstraintGlyph {
public:
  ConstraintGlyph();
  ~ConstraintGlyph();
  ConstraintGlyph(const ConstraintGlyph&) = delete;
  ConstraintGlyph& operator=(const ConstraintGlyph&) = delete;

  /// Draws in `renderer` from now on. Null: nowhere.
  void setRenderer(vtkRenderer* renderer);
  void setTheme(const Theme& theme);

  /// Shows the plane through `origin` (mm) perpendicular to `normal`, and the arrow along it. A zero normal
  /// hides both.
  void show(const Vec3& origin, const Vec3& normal);
  void hide();
  bool visible() const;

  /// Has to be called after organs were added to the renderer: the disc is blended over them. `OrganView`
  /// does it.
  void drawAfterOrgans();

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace viscera::scene
