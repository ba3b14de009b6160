#pragma once

#include <memory>

#include "viscera/core/arrays.h"
#include "viscera/scene/theme.h"

class vtkRenderer;

namespace viscera::scene {

struct ViewGeometry;

/// The base class of small markers that a view draws over its organs while the user works with them. They are
/// hidden at first; parts behind an organ are drawn fainter. Belongs to the thread that renders.
class HelperGlyph {
public:
  virtual ~HelperGlyph();
  HelperGlyph(const HelperGlyph&) = delete;
  HelperGlyph& operator=(const HelperGlyph&) = delete;

  /// Sets the renderer to draw in; null: none.
  void setRenderer(vtkRenderer* renderer);
  virtual void setTheme(const Theme& theme) = 0;
  void hide();
  bool visible() const;
  /// Has to be called after organs were added to the renderer: the glyph is blended over them. `OrganView`
  /// does it for its own glyphs.
  void drawAfterOrgans();

protected:
  struct Parts;

  HelperGlyph();
  void setVisible(bool visible);
  /// Called before every frame while the glyph is visible, to keep its size on the screen.
  virtual void follow(const ViewGeometry& view);

  std::unique_ptr<Parts> parts_;
};

/// Shows where a locked handle may go: the allowed plane as a translucent disc with a rim, and the gradient
/// that it is perpendicular to as an arrow. Sizes follow the zoom.
class ConstraintGlyph final : public HelperGlyph {
public:
  ConstraintGlyph();

  void setTheme(const Theme& theme) override;
  /// Shows the plane through `origin` (mm) perpendicular to `normal`, and the arrow along it. A zero normal
  /// hides both.
  void show(const Vec3& origin, const Vec3& normal);

private:
  void follow(const ViewGeometry& view) override;

  Vec3 origin_ = Vec3::Zero();
  Vec3 normal_ = Vec3::UnitX();
};

/// Shows the plane at which symmetric drags are mirrored: a faint square with a rim.
class MirrorPlaneGlyph final : public HelperGlyph {
public:
  MirrorPlaneGlyph();

  void setTheme(const Theme& theme) override;
  /// Shows the square around `center` (mm) perpendicular to the unit `normal`, `halfSize` mm to each side.
  void show(const Vec3& center, const Vec3& normal, double halfSize);
};

/// Marks a place with a small ball of constant size on the screen.
class ProbeMarker final : public HelperGlyph {
public:
  ProbeMarker();

  void setTheme(const Theme& theme) override;
  void show(const Vec3& position);
  const Vec3& position() const { return position_; }

private:
  void follow(const ViewGeometry& view) override;

  Vec3 position_ = Vec3::Zero();
};

} // namespace viscera::scene
