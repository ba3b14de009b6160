#pragma once

#include <memory>
#include <vector>

#include <Eigen/Geometry>

#include "viscera/core/arrays.h"
#include "viscera/scene/color_map.h"

class vtkActor;
class vtkRenderer;

namespace viscera::scene {

/// The principal stretches of tissue at one place.
struct StretchGlyph {
  Vec3 position = Vec3::Zero();                                   ///< mm, in the deformed body.
  Eigen::Quaterniond directions = Eigen::Quaterniond::Identity(); ///< Turns x, y, z into the directions,
  Vec3 stretches = Vec3::Ones();                                  ///< of these factors.
  double value = 0;                                               ///< For its colour.
};

/// Draws the principal stretches of tissue as glyphs: ellipsoids, or crosses of their axes; one instanced
/// mapper for all of them. Belongs to the thread that renders.
class StretchGlyphs {
public:
  enum class Shape { ellipsoids, crosses };

  StretchGlyphs();
  ~StretchGlyphs();
  StretchGlyphs(const StretchGlyphs&) = delete;
  StretchGlyphs& operator=(const StretchGlyphs&) = delete;

  /// Sets the renderer to draw in; null: none.
  void setRenderer(vtkRenderer* renderer);

  /// Replaces the glyphs. O(glyphs).
  void set(const std::vector<StretchGlyph>& glyphs);
  int count() const;
  void setShape(Shape shape);
  /// The radius of a glyph that is not stretched, mm.
  void setRadius(double radius);
  void setColors(const ColorMap& map, ValueRange range);
  void setVisible(bool visible);
  bool visible() const;

  vtkActor* actor() const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace viscera::scene
