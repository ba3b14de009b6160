#include "viscera/geometry/split_edges.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace viscera::geometry {
namespace {

using CornerIndices = std::array<std::int32_t, 3>;

/// One round: halves every edge that is too long.
class Round {
public:
  Round(std::vector<Vec3>& points, double longest) : points_(points), longest_(longest) {}

  bool halvedAny() const { return !middles_.empty(); }

  std::vector<CornerIndices> split(const std::vector<CornerIndices>& triangles) {
    std::vector<CornerIndices> result;
    for (const CornerIndices& t : triangles)
      split(t, result);
    return result;
  }

private:
  /// The point in the middle of an edge, or -1 for one that stays.
  std::int32_t middle(std::int32_t a, std::int32_t b) {
    if (a > b) // Both triangles of the edge compute the same numbers.
      std::swap(a, b);
    const Vec3 from = points_[static_cast<std::size_t>(a)], to = points_[static_cast<std::size_t>(b)];
    if ((to - from).norm() <= longest_)
      return -1;
    const auto key = static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint64_t>(b);
    const auto [entry, fresh] = middles_.try_emplace(key, static_cast<std::int32_t>(points_.size()));
    if (fresh)
      points_.push_back(0.5 * (from + to));
    return entry->second;
  }

  void split(const CornerIndices& t, std::vector<CornerIndices>& result) {
    std::array<std::int32_t, 3> m;
    for (std::size_t k = 0; k < 3; ++k)
      m[k] = middle(t[k], t[(k + 1) % 3]);
    const auto halved = std::count_if(m.begin(), m.end(), [](std::int32_t i) { return i >= 0; });
    if (halved == 0) {
      result.push_back(t);
    } else if (halved == 3) {
      result.insert(result.end(), {CornerIndices{t[0], m[0], m[2]}, CornerIndices{m[0], t[1], m[1]},
                                   CornerIndices{m[2], m[1], t[2]}, CornerIndices{m[0], m[1], m[2]}});
    } else if (halved == 1) {
      const auto k = static_cast<std::size_t>(std::max_element(m.begin(), m.end()) - m.begin());
      const std::int32_t far = t[(k + 2) % 3];
      result.insert(result.end(), {CornerIndices{t[k], m[k], far}, CornerIndices{m[k], t[(k + 1) % 3], far}});
    } else {
      // The corner between the two halved edges is cut off; the rest is a quadrilateral.
      const auto whole = static_cast<std::size_t>(std::min_element(m.begin(), m.end()) - m.begin());
      const std::size_t next = (whole + 1) % 3, last = (whole + 2) % 3;
      result.insert(result.end(),
                    {CornerIndices{m[next], t[last], m[last]}, CornerIndices{t[whole], t[next], m[next]},
                     CornerIndices{t[whole], m[next], m[last]}});
    }
  }

  std::vector<Vec3>& points_;
  double longest_;
  std::unordered_map<std::uint64_t, std::int32_t> middles_;
};

} // namespace

TriangleMesh splitLongEdges(const TriangleMesh& mesh, double longest, int mostTriangles) {
  std::vector<Vec3> points;
  for (Eigen::Index i = 0; i < mesh.points.rows(); ++i)
    points.push_back(mesh.points.row(i).transpose());
  std::vector<CornerIndices> triangles;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    triangles.push_back({mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2)});
  // A round makes at most four triangles of one.
  while (4 * triangles.size() <= static_cast<std::size_t>(mostTriangles)) {
    Round round(points, longest);
    triangles = round.split(triangles);
    if (!round.halvedAny())
      break;
  }
  TriangleMesh result;
  result.points = pointsOf(points);
  result.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    result.triangles.row(static_cast<Eigen::Index>(t)) << triangles[t][0], triangles[t][1], triangles[t][2];
  return result;
}

} // namespace viscera::geometry
