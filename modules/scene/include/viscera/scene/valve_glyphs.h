#pragma once

#include <memory>
#include <vector>

#include "viscera/core/arrays.h"

class vtkRenderer;

namespace viscera::scene {

/// The leaflets and the ring of a valve to be drawn.
struct ValveGlyph {
  Points points; ///< Of its leaflets, mm.
  Triangles triangles;
  std::vector<Points> rims; ///< Lines along which leaflets are fixed, and their free edges: drawn as cords.
  std::vector<Points> edges;
  std::vector<Points> chords = {}; ///< Lines that hold the leaflets, drawn as thin pale cords.
};

/// An arrow that shows flowing blood, mm.
struct FlowArrow {
  Vec3 tail = Vec3::Zero();
  Vec3 head = Vec3::UnitX();
  double radius = 1; ///< Of the shaft.
  Vec3 color = Vec3::Ones();
};

/// Draws the leaflets of heart valves, their rings, the chords that hold them, and arrows for the blood that
/// flows through them. None of these can be picked. Belongs to the thread that renders.
class ValveGlyphs {
public:
  ValveGlyphs();
  ~ValveGlyphs();
  ValveGlyphs(const ValveGlyphs&) = delete;
  ValveGlyphs& operator=(const ValveGlyphs&) = delete;

  /// Sets the renderer to draw in; null: none.
  void setRenderer(vtkRenderer* renderer);

  /// Replaces the glyphs that are drawn; empty lists draw nothing. O(points). An arrow without a length is
  /// left out.
  void set(const std::vector<ValveGlyph>& valves, const std::vector<FlowArrow>& arrows);
  /// The number of valves that are drawn.
  int valves() const;
  int arrows() const;
  /// Counts the valves' chords.
  int chords() const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace viscera::scene
