#pragma once

#include <string>
#include <utility>
#include <vector>

#include "viscera/coordinates/handle_set.h"
#include "viscera/coordinates/space_layout.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/convex_polytope.h"

/// Divides space into the regions and zones of localised Celestial coordinates (thesis 4.5), in which groups
/// of handles act inside their regions only.
namespace viscera::localised_scc {

/// The convex hull of one group.
struct Region {
  std::string name;
  std::vector<int> handles; ///< Ascending.
  geometry::ConvexPolytope hull;
  double offset = 0; ///< mm: how far from a zone its super-region still counts.
  double offsetBound =
      0; ///< mm: the offset is kept below it; infinite when no handle lies outside the zones.
};

/// Where regions meet, connected: the union of the pairwise intersections `parts`. Touching in a face, an
/// edge or a point counts.
struct SwappingZone {
  struct Part {
    int first = 0; ///< The two regions, ascending.
    int second = 0;
    geometry::ConvexPolytope common;
  };
  std::vector<Part> parts;
  std::vector<int> regions;             ///< All regions involved, ascending.
  std::vector<int> handles;             ///< All their handles, ascending: those of the super-region.
  geometry::ConvexPolytope superRegion; ///< The hull of `handles`.
};

/// Regions, zones and super-regions of grouped handles, and how a point mixes their coordinates.
///
/// The thesis forms zones as seen from each region; where three regions meet that makes coordinates jump,
/// because two neighbours may have different sets of handles. Here a zone is a connected component over all
/// pairs of regions, the same from every region. Between several zones of one region the weights are `rho_k
/// prod_{l != k} (1 - rho_l)` and, for the region itself, `prod (1 - rho_l)`, divided by their sum.
/// Immutable, thread-safe.
///
///     const RegionLayout layout(handles, 5);
///     double sum = 0; // 1
///     for (const RegionLayout::Share& share : layout.shares(point))
///       sum += share.weight;
class RegionLayout {
public:
  /// All handles form one region where there are no groups. `offset` (mm, > 0) is reduced to a region's bound
  /// where it exceeds it, with a note. Throws `DataError` that names the group when one has fewer than four
  /// handles or is flat.
  RegionLayout(const coordinates::HandleSet& handles, double offset);

  const std::vector<Region>& regions() const { return regions_; }
  const std::vector<SwappingZone>& zones() const { return zones_; }
  const std::vector<Text>& notes() const { return notes_; }

  /// The number of sets of handles with coordinates of their own: the regions, then the zones' super-regions.
  int setCount() const { return static_cast<int>(regions_.size() + zones_.size()); }
  const std::vector<int>& handlesOf(int set) const;

  /// One set's part in a point's coordinates: `weight` in (0, 1], and its derivative, 1/mm.
  struct Share {
    int set = 0;
    double weight = 0;
    Vec3 gradient = Vec3::Zero();
  };
  /// The shares at `point`, which add up to 1; none when it lies in no region. O(regions + faces of near
  /// zones).
  std::vector<Share> shares(const Vec3& point) const;
  /// The same into `shares`, whose memory is used again: for many points.
  void shares(const Vec3& point, std::vector<Share>& shares) const;

private:
  void makeRegions(const coordinates::HandleSet& handles);
  void makeZones(const coordinates::HandleSet& handles);
  void boundOffsets(const coordinates::HandleSet& handles, double offset);
  int zoneAt(const Vec3& point) const;
  void blendWithZones(int own, const Vec3& point, std::vector<Share>& shares) const;

  double tolerance_ = 0;
  std::vector<Region> regions_;
  std::vector<SwappingZone> zones_;
  std::vector<Text> notes_;
};

/// The parts of `layout`, which was made from `groups` groups, for drawing; with the upper bound of the
/// parameter `offsetName`.
coordinates::SpaceLayout spaceLayoutOf(const RegionLayout& layout, std::size_t groups,
                                       const std::string& offsetName);

} // namespace viscera::localised_scc
