#pragma once

#include <array>
#include <memory>
#include <vector>

#include "viscera/coordinates/space_layout.h"
#include "viscera/core/arrays.h"

class vtkRenderer;

namespace viscera::scene {

/// A convex body to be drawn: its faces tinted and transparent, its sharp edges as lines. A flat one is a
/// pane, one without faces a thick line or a dot.
struct RegionHull {
  Points vertices;                       ///< `n x 3` mm.
  Triangles triangles;                   ///< Over `vertices`; may be none.
  std::vector<std::array<int, 2>> edges; ///< Pairs of `vertices`; one with itself is a dot.
  Vec3 color = Vec3::Ones();             ///< Red green blue, 0 to 1.
  double opacity = 0.1;                  ///< Of the faces, 0 to 1; the lines are opaquer.
};

/// The parts of a layout that are drawn: regions, zones, super-regions.
struct LayoutParts {
  bool regions = true;
  bool zones = false;
  bool superRegions = false;
  bool any() const { return regions || zones || superRegions; }
  bool operator==(const LayoutParts&) const = default;
};

/// The hulls of a layout: regions in the colours of their groups (`groupColors`, red green blue, 0 to 1; grey
/// where there is none), zones in red, super-regions in yellow, as in the thesis's figure 4.15.
std::vector<RegionHull> layoutHulls(const coordinates::SpaceLayout& layout,
                                    const std::vector<Vec3>& groupColors, const LayoutParts& shown);

/// The hull of a cage, from its triangles over the handles (`n x 3` mm), in the grey of handles without a
/// group.
RegionHull cageHull(const Points& handles, const Triangles& cage);

/// Draws translucent hulls around the organs: regions, zones and super-regions of grouped handles. They hide
/// nothing, are translucent from any side, and edges behind an organ are drawn fainter. Belongs to the thread
/// that renders.
class RegionHulls {
public:
  RegionHulls();
  ~RegionHulls();
  RegionHulls(const RegionHulls&) = delete;
  RegionHulls& operator=(const RegionHulls&) = delete;

  /// Sets the renderer to draw in; null: none.
  void setRenderer(vtkRenderer* renderer);

  /// Replaces the hulls that are shown; an empty list hides all. O(faces), quick enough for every move of a
  /// drag.
  void setHulls(std::vector<RegionHull> hulls);
  const std::vector<RegionHull>& hulls() const;

  /// Has to be called after organs were added to the renderer: hulls are blended over them. `OrganView` does
  /// it.
  void drawAfterOrgans();

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace viscera::scene
