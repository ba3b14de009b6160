#pragma once

#include <vector>

#include "viscera/coordinates/space_layout.h"
#include "viscera/scene/region_hulls.h"

namespace viscera::scene {

/// Which parts of a layout are drawn.
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

/// A cage as it is drawn, by its triangles over the handles (`n x 3` mm), in the grey of what has no group.
RegionHull cageHull(const Points& handles, const Triangles& cage);

} // namespace viscera::scene
