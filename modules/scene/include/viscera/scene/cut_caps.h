#pragma once

#include <memory>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/geometry/plane_cut.h"

class vtkRenderer;

namespace viscera::scene {

/// Draws the faces that close surfaces where a plane cuts them open, such as the cut wall of a heart. Belongs
/// to the thread that renders.
class CutCaps {
public:
  CutCaps();
  ~CutCaps();
  CutCaps(const CutCaps&) = delete;
  CutCaps& operator=(const CutCaps&) = delete;

  /// One face: between the lines of the outer surface and those of the cavities in it.
  struct Face {
    geometry::PlaneCut outer;
    std::vector<geometry::PlaneCut> cavities;
    Vec3 color = Vec3::Ones();
  };

  /// Sets the renderer to draw in; null: none.
  void setRenderer(vtkRenderer* renderer);
  /// Draws these faces, all in one plane, and no others. Open lines bound nothing and are left out. `towards`
  /// is the unit normal that faces the reader. O(p log p) for p points of lines.
  void setFaces(const std::vector<Face>& faces, const Vec3& towards);
  /// The area of all faces, mm^2.
  double areaMm2() const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace viscera::scene
