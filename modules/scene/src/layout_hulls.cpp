#include "viscera/scene/layout_hulls.h"

#include <algorithm>
#include <set>

namespace viscera::scene {
namespace {

using Kind = coordinates::SpacePart::Kind;

const Vec3 kNoGroup(0.62, 0.66, 0.70);
const Vec3 kZone(0.90, 0.22, 0.20);
const Vec3 kSuperRegion(0.95, 0.85, 0.25);
constexpr double kRegionOpacity = 0.12;
constexpr double kZoneOpacity = 0.30;
constexpr double kSuperRegionOpacity = 0.05;

bool isShown(const LayoutParts& shown, Kind kind) {
  switch (kind) {
  case Kind::region:
    return shown.regions;
  case Kind::zone:
    return shown.zones;
  case Kind::superRegion:
    return shown.superRegions;
  }
  return false;
}

} // namespace

std::vector<RegionHull> layoutHulls(const coordinates::SpaceLayout& layout,
                                    const std::vector<Vec3>& groupColors, const LayoutParts& shown) {
  std::vector<RegionHull> hulls;
  for (const coordinates::SpacePart& part : layout.parts) {
    if (!isShown(shown, part.kind))
      continue;
    RegionHull hull{part.vertices, part.triangles, part.edges, kNoGroup, kRegionOpacity};
    if (part.kind == Kind::zone) {
      hull.color = kZone;
      hull.opacity = kZoneOpacity;
    } else if (part.kind == Kind::superRegion) {
      hull.color = kSuperRegion;
      hull.opacity = kSuperRegionOpacity;
    } else if (!part.groups.empty() && static_cast<std::size_t>(part.groups.front()) < groupColors.size()) {
      hull.color = groupColors[static_cast<std::size_t>(part.groups.front())];
    }
    hulls.push_back(std::move(hull));
  }
  return hulls;
}

RegionHull cageHull(const Points& handles, const Triangles& cage) {
  std::set<std::array<int, 2>> edges;
  for (Eigen::Index t = 0; t < cage.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = cage(t, k), b = cage(t, (k + 1) % 3);
      edges.insert({std::min(a, b), std::max(a, b)});
    }
  return {handles, cage, {edges.begin(), edges.end()}, kNoGroup, kRegionOpacity};
}

} // namespace viscera::scene
