#pragma once

#include <memory>

#include "viscera/core/arrays.h"
#include "viscera/scene/theme.h"

class vtkRenderer;

namespace viscera::scene {

/// The plane that symmetric drags are mirrored at: a faint square with a rim, fainter where an organ hides
/// it. Belongs to the thread that renders.
class MirrorPlaneGlyph {
public:
  MirrorPlaneGlyph();
  ~MirrorPlaneGlyph();
  MirrorPlaneGlyph(const MirrorPlaneGlyph&) = delete;
  MirrorPlaneGlyph& operator=(const MirrorPlaneGlyph&) = delete;

  /// Draws in `renderer` from now on. Null: nowhere.
  void setRenderer(vtkRenderer* renderer);
  void setTheme(const Theme& theme);

  /// Shows the square around `center` (mm) perpendicular to the unit `normal`, `halfSize` mm to each side.
  void show(const Vec3& center, const Vec3& normal, double halfSize);
  void hide();
  bool visible() const;

  /// Has to be called after organs were added to the renderer. `OrganView` does it.
  void drawAfterOrgans();

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace viscera::scene
