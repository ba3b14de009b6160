#include "cage/coplanar_groups.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "viscera/geometry/triangle_mesh.h"

namespace viscera::coordinates {
namespace {

/// Part of the cage's size: triangles whose planes differ by less are one face.
constexpr double kOnePlane = 1e-9;

struct Facet {
  Vec3 corner, normal;
  std::pair<int, int> longest; ///< The handles at the ends of its longest edge.
  bool needle;                 ///< Its normal is nothing but rounding.
};

Facet facetOf(const Points& handles, const Triangles& cage, Eigen::Index t, double tolerance) {
  const auto corners = geometry::cornersOf(handles, cage, t);
  Facet facet{corners[0], (corners[1] - corners[0]).cross(corners[2] - corners[0]), {}, false};
  double length = -1;
  for (std::size_t i = 0; i < 3; ++i)
    if (const double own = (corners[(i + 1) % 3] - corners[i]).norm(); own > length) {
      length = own;
      facet.longest = std::minmax(cage(t, static_cast<int>(i)), cage(t, static_cast<int>(i + 1) % 3));
    }
  // |n| is the longest edge's length times the height over it.
  facet.needle = facet.normal.norm() <= tolerance * length;
  facet.normal.normalize();
  return facet;
}

bool liesIn(const Facet& plane, const Points& handles, const Eigen::RowVector3i& triangle, double tolerance) {
  for (const int corner : triangle)
    if (std::abs((handles.row(corner).transpose() - plane.corner).dot(plane.normal)) > tolerance)
      return false;
  return true;
}

} // namespace

std::vector<int> coplanarGroups(const Points& handles, const Triangles& cage) {
  const double tolerance = kOnePlane * boundsOf(handles).diagonal();
  std::vector<int> group(static_cast<std::size_t>(cage.rows()));
  std::iota(group.begin(), group.end(), 0);
  std::vector<Facet> facets;
  std::map<std::pair<int, int>, int> owners;
  for (int t = 0; t < static_cast<int>(cage.rows()); ++t) {
    facets.push_back(facetOf(handles, cage, t, tolerance));
    for (int i = 0; i < 3; ++i)
      owners[{cage(t, i), cage(t, (i + 1) % 3)}] = t;
  }
  for (const auto& [edge, t] : owners) {
    const auto other = owners.find({edge.second, edge.first});
    if (other == owners.end())
      continue;
    const Facet &one = facets[static_cast<std::size_t>(t)],
                &two = facets[static_cast<std::size_t>(other->second)];
    const std::pair<int, int> ends = std::minmax(edge.first, edge.second);
    const bool together = one.needle || two.needle
                              ? (one.needle && one.longest == ends) || (two.needle && two.longest == ends)
                              : liesIn(one, handles, cage.row(other->second), tolerance);
    if (!together)
      continue;
    const int from = group[static_cast<std::size_t>(t)], to = group[static_cast<std::size_t>(other->second)];
    std::replace(group.begin(), group.end(), std::max(from, to), std::min(from, to));
  }
  return group;
}

} // namespace viscera::coordinates
