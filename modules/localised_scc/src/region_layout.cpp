#include "viscera/localised_scc/region_layout.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "blend.h"
#include "viscera/coordinates/handle_checks.h"
#include "viscera/core/disjoint_sets.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::localised_scc {
namespace {

/// The distance that counts as touching, as a fraction of the handles' diagonal.
constexpr double kTouching = 1e-9;
/// The bound itself is excluded (h < d_k).
constexpr double kBelowBound = 0.999;

std::vector<int> sortedUnique(std::vector<int> list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

Region makeRegion(const coordinates::HandleGroup& group, const Points& positions, double tolerance) {
  const Text where = phrase("group '%1'", named(group.name));
  const std::vector<int> handles = sortedUnique(group.handles);
  for (const int handle : handles)
    if (handle < 0 || handle >= positions.rows())
      throw DataError(misuse("It refers to handle %1, but there are %2", handle, positions.rows()), where);
  if (handles.size() < 4)
    throw DataError(phrase("It has %n {handle|handles}; a region needs at least 4", handles.size()), where,
                    "add handles to it");
  auto hull = geometry::ConvexPolytope::hullOf(positions(handles, Eigen::all), tolerance);
  if (hull.dimension() < 3)
    throw DataError("all its handles lie in one plane, so its region is flat", where,
                    "add a handle off that plane");
  return {group.name, handles, std::move(hull), 0, 0};
}

std::vector<SwappingZone::Part> pairwiseIntersections(const std::vector<Region>& regions) {
  std::vector<SwappingZone::Part> parts;
  for (int i = 0; i < static_cast<int>(regions.size()); ++i)
    for (int j = i + 1; j < static_cast<int>(regions.size()); ++j)
      if (auto common = regions[std::size_t(i)].hull.intersection(regions[std::size_t(j)].hull))
        parts.push_back({i, j, std::move(*common)});
  return parts;
}

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

RegionLayout::RegionLayout(const coordinates::HandleSet& handles, double offset) {
  assert(offset > 0);
  coordinates::requireUsableHandles<3>(handles.positions);
  tolerance_ = kTouching * boundsOf(handles.positions).diagonal();
  makeRegions(handles);
  makeZones(handles);
  boundOffsets(handles, offset);
}

void RegionLayout::makeRegions(const coordinates::HandleSet& handles) {
  std::vector<coordinates::HandleGroup> groups = handles.groups;
  if (groups.empty()) {
    std::vector<int> all(static_cast<std::size_t>(handles.positions.rows()));
    std::iota(all.begin(), all.end(), 0);
    groups.push_back({"all handles", std::move(all)});
  }
  std::vector<bool> used(static_cast<std::size_t>(handles.positions.rows()), false);
  for (const auto& group : groups) {
    regions_.push_back(makeRegion(group, handles.positions, tolerance_));
    for (const int handle : regions_.back().handles)
      used[static_cast<std::size_t>(handle)] = true;
  }
  const auto idle = std::count(used.begin(), used.end(), false);
  if (idle > 0)
    notes_.push_back(
        phrase("%n {handle is in no group and moves|handles are in no group and move} nothing", idle));
}

void RegionLayout::makeZones(const coordinates::HandleSet& handles) {
  auto parts = pairwiseIntersections(regions_);
  // A zone is a connected component of the parts H_i n H_j (H: hulls of the regions); two parts are joined
  // where they meet.
  DisjointSets components(parts.size());
  for (std::size_t a = 0; a < parts.size(); ++a)
    for (std::size_t b = a + 1; b < parts.size(); ++b)
      if (parts[a].common.intersection(parts[b].common))
        components.join(a, b);

  for (std::size_t root = 0; root < parts.size(); ++root) {
    if (components.root(root) != root)
      continue;
    std::vector<SwappingZone::Part> members;
    std::vector<int> regions, zoneHandles;
    for (std::size_t a = root; a < parts.size(); ++a) {
      if (components.root(a) != root)
        continue;
      for (const int region : {parts[a].first, parts[a].second}) {
        regions.push_back(region);
        const auto& own = regions_[std::size_t(region)].handles;
        zoneHandles.insert(zoneHandles.end(), own.begin(), own.end());
      }
      members.push_back(std::move(parts[a]));
    }
    zoneHandles = sortedUnique(std::move(zoneHandles));
    auto superRegion =
        geometry::ConvexPolytope::hullOf(handles.positions(zoneHandles, Eigen::all), tolerance_);
    zones_.push_back({std::move(members), sortedUnique(std::move(regions)), std::move(zoneHandles),
                      std::move(superRegion)});
  }
}

void RegionLayout::boundOffsets(const coordinates::HandleSet& handles, double offset) {
  for (int i = 0; i < static_cast<int>(regions_.size()); ++i) {
    Region& region = regions_[std::size_t(i)];
    region.offsetBound = std::numeric_limits<double>::infinity();
    for (const auto& zone : zones_) {
      for (const int handle : region.handles) {
        const Vec3 v = handles.positions.row(handle).transpose();
        double distance = std::numeric_limits<double>::infinity();
        for (const auto& part : zone.parts)
          if (part.first == i || part.second == i)
            distance = std::min(distance, (part.common.closestPoint(v) - v).norm());
        if (distance > 4 * tolerance_)
          region.offsetBound = std::min(region.offsetBound, distance);
      }
    }
    // h_i < min |v - Z| over the handles v of the region that lie off the zones Z: no blend reaches them.
    region.offset = std::min(offset, kBelowBound * region.offsetBound);
    if (region.offset < offset)
      notes_.push_back(
          phrase("the offset of region '%1' is cut to %2 mm, the distance of its nearest handle from a zone",
                 named(region.name), inDigits(region.offset)));
  }
}

const std::vector<int>& RegionLayout::handlesOf(int set) const {
  const auto index = static_cast<std::size_t>(set);
  return index < regions_.size() ? regions_[index].handles : zones_[index - regions_.size()].handles;
}

/// The zone that holds a point of two or more regions; -1 when rounding alone put it in several.
int RegionLayout::zoneAt(const Vec3& point) const {
  const auto inside = [&](int region) { return regions_[std::size_t(region)].hull.contains(point); };
  for (std::size_t k = 0; k < zones_.size(); ++k)
    for (const auto& part : zones_[k].parts)
      if (inside(part.first) && inside(part.second))
        return static_cast<int>(k);
  return -1;
}

/// The shares of a point that lies in region `own` and in no zone.
void RegionLayout::blendWithZones(int own, const Vec3& point, std::vector<Share>& shares) const {
  const double offset = regions_[std::size_t(own)].offset;
  std::vector<BlendValue> blends; // Takes no memory as long as no zone is near.
  for (std::size_t k = 0; k < zones_.size(); ++k) {
    // d_k = min |point - closest point of Z|, over the parts of zone k that lie in this region.
    double distance = offset;
    Vec3 away = Vec3::Zero();
    for (const auto& part : zones_[k].parts) {
      if ((part.first != own && part.second != own) || part.common.signedDistance(point) >= distance)
        continue;
      const Vec3 from = point - part.common.closestPoint(point);
      if (from.norm() >= distance)
        continue;
      distance = from.norm();
      away = distance > 0 ? Vec3(from / distance) : from;
    }
    if (distance >= offset)
      continue;
    shares.push_back({static_cast<int>(regions_.size() + k), 0, Vec3::Zero()});
    blends.push_back(blendAt(distance, away, offset));
  }
  shares.push_back({own, 1, Vec3::Zero()});
  if (blends.empty())
    return;
  const auto parts = partition(blends);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    shares[k].weight = parts[k].value;
    shares[k].gradient = parts[k].gradient;
  }
  std::erase_if(shares, [](const Share& share) { return !(share.weight > 0); });
}

void RegionLayout::shares(const Vec3& point, std::vector<Share>& shares) const {
  shares.clear();
  int own = -1, containing = 0;
  for (int i = 0; i < static_cast<int>(regions_.size()); ++i)
    if (regions_[std::size_t(i)].hull.contains(point)) {
      own = containing == 0 ? i : own;
      ++containing;
    }
  if (containing == 0)
    return;
  if (containing > 1)
    if (const int zone = zoneAt(point); zone >= 0) {
      shares.push_back({static_cast<int>(regions_.size()) + zone, 1, Vec3::Zero()});
      return;
    }
  blendWithZones(own, point, shares);
}

std::vector<RegionLayout::Share> RegionLayout::shares(const Vec3& point) const {
  std::vector<Share> result;
  shares(point, result);
  return result;
}

coordinates::SpaceLayout spaceLayoutOf(const RegionLayout& layout, std::size_t groups,
                                       const std::string& offsetName) {
  // The one region is that of all handles where there are no groups.
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
