#include "space_layout_of.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace viscera::localised_scc {
namespace {

using coordinates::SpacePart;

SpacePart partOf(SpacePart::Kind kind, std::string name, std::vector<int> groups,
                 const geometry::ConvexPolytope& set) {
  return {kind, std::move(name), std::move(groups), set.vertices(), set.triangles(), set.edges()};
}

std::string joinedNames(const RegionLayout& layout, const std::vector<int>& regions) {
  std::string names;
  for (const int region : regions)
    names += (names.empty() ? "" : " + ") + layout.regions()[static_cast<std::size_t>(region)].name;
  return names;
}

} // namespace

coordinates::SpaceLayout spaceLayoutOf(const RegionLayout& layout, std::size_t groups,
                                       const std::string& offsetName) {
  // Without groups the one region is that of all handles.
  const auto ofRegions = [groups](std::vector<int> regions) {
    return groups == 0 ? std::vector<int>() : regions;
  };
  coordinates::SpaceLayout space;
  space.notes = layout.notes();
  double bound = 0;
  for (int i = 0; i < static_cast<int>(layout.regions().size()); ++i) {
    const Region& region = layout.regions()[static_cast<std::size_t>(i)];
    space.parts.push_back(partOf(SpacePart::Kind::region, region.name, ofRegions({i}), region.hull));
    if (std::isfinite(region.offsetBound))
      bound = std::max(bound, region.offsetBound);
  }
  for (const SwappingZone& zone : layout.zones()) {
    const std::string name = joinedNames(layout, zone.regions);
    for (const SwappingZone::Part& part : zone.parts)
      space.parts.push_back(
          partOf(SpacePart::Kind::zone, name, ofRegions({part.first, part.second}), part.common));
    space.parts.push_back(
        partOf(SpacePart::Kind::superRegion, name, ofRegions(zone.regions), zone.superRegion));
  }
  if (bound > 0)
    space.upperBounds[offsetName] = bound;
  return space;
}

} // namespace viscera::localised_scc
