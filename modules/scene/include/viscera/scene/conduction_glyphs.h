#pragma once

#include <memory>
#include <vector>

#include "viscera/core/arrays.h"

class vtkRenderer;

namespace viscera::scene {

/// A line of a heart's conduction system.
struct ConductionLine {
  Points points; ///< `n x 3`, mm.
  double radiusMm = 1;
  Values lit; ///< `n`, 0 (at rest) to 1 (the front of the excitation is there).
};

/// Draws the lines of a heart's conduction system as cords, brighter where they are excited. For the thread
/// that renders.
class ConductionGlyphs {
public:
  ConductionGlyphs();
  ~ConductionGlyphs();
  ConductionGlyphs(const ConductionGlyphs&) = delete;
  ConductionGlyphs& operator=(const ConductionGlyphs&) = delete;

  /// Draws into this renderer, which has to outlive the glyphs or be replaced; null: into none.
  void setRenderer(vtkRenderer* renderer);

  /// Draws these lines; an empty list removes all.
  void set(std::vector<ConductionLine> lines);
  const std::vector<ConductionLine>& lines() const { return lines_; }

private:
  struct Parts;
  std::vector<ConductionLine> lines_;
  std::unique_ptr<Parts> parts_;
};

} // namespace viscera::scene
