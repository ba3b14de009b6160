#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "viscera/scene/tissue_actor.h"

/// Computes the faces between tetrahedra, and the cut of tetrahedra by a plane, to draw the inside of an
/// organ.
namespace viscera::scene {

/// A triangle between two tetrahedra, or at the outside of one.
struct TetraFace {
  std::array<std::int32_t, 3> corners{}; ///< Counter-clockwise seen from outside of the first tetrahedron.
  std::int32_t first = -1;
  std::int32_t second = -1; ///< -1: nothing on the other side.
};

/// Every face once, in an order that depends on the tetrahedra only. `points` determine the outside of each.
/// O(t).
std::vector<TetraFace> tetraFaces(const Tetrahedra& tetrahedra, const Points& points);

/// The cut of tetrahedra by a plane: triangles with their own corners, and numbers interpolated at them.
/// Reuse the object in every frame to reuse its memory.
struct PlaneCut {
  std::vector<double> points;        ///< Three a corner.
  std::vector<double> values;        ///< One for each corner; empty without values.
  std::vector<std::int32_t> corners; ///< 0, 1, 2, ...
  std::vector<std::int32_t> owners;  ///< The tetrahedron of each triangle.

  /// Cuts the tetrahedra for which `shown` is not zero (empty: all). The triangles face the side that is cut
  /// away. O(t).
  void make(const Tetrahedra& tetrahedra, const Points& at, const Values* numbers,
            const std::vector<char>& shown, const CutPlane& plane);
  void clear();

private:
  std::vector<double> side_;
};

} // namespace viscera::scene
