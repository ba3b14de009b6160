#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "viscera/core/arrays.h"

namespace viscera::geometry {

/// The shortest way between two surfaces.
struct SurfaceGap {
  double mm = 0;            ///< 0 where they touch or cross.
  Vec3 from = Vec3::Zero(); ///< Its end on the first surface, mm; where they cross, a place of that.
  Vec3 to = Vec3::Zero();   ///< Its end on the second one.
  int triangleFrom = -1;    ///< The triangles of the ends.
  int triangleTo = -1;
};

/// Boxes around the triangles of a surface, in a tree that is arranged once and follows the surface as it
/// moves. For one thread; measuring alone may be done from several.
///
///     SurfaceBoxes liver(a.points, a.triangles), vessel(b.points, b.triangles);
///     SurfaceGap gap = gapBetween(liver, vessel);
///     liver.follow(moved); // Each pose of a drag.
///     gap = gapBetween(liver, vessel, gap);
class SurfaceBoxes {
public:
  /// Keeps copies; triangles are rows of `points` and assumed to be in range. O(m log m).
  SurfaceBoxes(Points points, Triangles triangles);

  /// Takes the surface's points in another pose. O(n + m).
  void follow(const Points& points);

  bool empty() const { return triangles_.rows() == 0; }

private:
  friend class GapSearch;
  struct Branch {
    Vec3 low = Vec3::Zero();
    Vec3 high = Vec3::Zero();
    std::int32_t begin = 0, end = 0; ///< In `order_`.
    std::int32_t second = 0;         ///< The second child; the first follows its parent. 0 for a leaf.
  };

  std::int32_t grow(const Points& middles, std::int32_t begin, std::int32_t end);
  void fit();

  Points points_;
  Triangles triangles_;
  std::vector<std::int32_t> order_;
  std::vector<Branch> branches_; ///< The root is the first; children come after their parents.
};

/// The shortest way between two surfaces, exact but for rounding: of every pair of triangles that boxes do
/// not rule out, the nearest places of corners and faces and of edges. A surface that lies inside of another
/// is as far from it as from the outside. `before` is a gap of the same surfaces in another pose, from which
/// the search begins: its result is the same, sooner. Of ways that are equally short, which one is found
/// depends on the tree only. Throws `UsageError` for a surface without triangles. About O(m) where surfaces
/// are smooth.
SurfaceGap gapBetween(const SurfaceBoxes& first, const SurfaceBoxes& second,
                      const std::optional<SurfaceGap>& before = std::nullopt);

} // namespace viscera::geometry
