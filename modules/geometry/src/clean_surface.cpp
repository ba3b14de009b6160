#include "viscera/geometry/clean_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <unordered_map>
#include <utility>
#include <vector>

#include "edge_uses.h"
#include "smallest_area.h"
#include "viscera/geometry/volume.h"

namespace viscera::geometry {
namespace {

/// A new number for every point, the same for those that go together, ascending by the first of them; -1 for
/// none.
struct Renaming {
  std::vector<std::int32_t> names;
  std::int32_t count = 0;
};

/// Points sorted along x meet their equals within a short stretch.
Renaming mergeNear(const Points& points, double distance) {
  std::vector<std::int32_t> order(static_cast<std::size_t>(points.rows()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return std::pair(points(a, 0), a) < std::pair(points(b, 0), b);
  });
  std::vector<std::int32_t> first(order.size());
  std::iota(first.begin(), first.end(), 0);
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      if (points(order[j], 0) - points(order[i], 0) > distance)
        break;
      const auto a = std::size_t(order[i]), b = std::size_t(order[j]);
      if (first[b] == order[j] && (points.row(order[i]) - points.row(order[j])).norm() <= distance)
        first[b] = first[a];
    }
  Renaming renaming{std::vector<std::int32_t>(first.size(), -1), 0};
  for (std::size_t i = 0; i < first.size(); ++i) {
    auto& name = renaming.names[static_cast<std::size_t>(first[i])];
    if (name < 0)
      name = renaming.count++;
    renaming.names[i] = name;
  }
  return renaming;
}

std::array<std::int32_t, 3> sortedCorners(const Triangles& triangles, Eigen::Index t) {
  std::array<std::int32_t, 3> corners = {triangles(t, 0), triangles(t, 1), triangles(t, 2)};
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// Keeps the triangles with an area, each once; `once` decides whether repeated ones go.
void dropUseless(TriangleMesh& mesh, bool once) {
  const double smallest = kSmallestRelativeArea * std::pow(boundsOf(mesh.points).diagonal(), 2);
  std::vector<std::pair<std::array<std::int32_t, 3>, Eigen::Index>> useful;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    if (areaOf(mesh.points, mesh.triangles, t) > smallest)
      useful.push_back({sortedCorners(mesh.triangles, t), t});
  if (once) {
    std::sort(useful.begin(), useful.end());
    useful.erase(std::unique(useful.begin(), useful.end(),
                             [](const auto& x, const auto& y) { return x.first == y.first; }),
                 useful.end());
    std::sort(useful.begin(), useful.end(), [](const auto& x, const auto& y) { return x.second < y.second; });
  }
  Eigen::Index kept = 0;
  for (const auto& entry : useful) // Ascending, so no row is overwritten before it is read.
    mesh.triangles.row(kept++) = mesh.triangles.row(entry.second).eval();
  mesh.triangles.conservativeResize(kept, 3);
}

void dropUnusedPoints(TriangleMesh& mesh) {
  std::vector<std::int32_t> names(static_cast<std::size_t>(mesh.points.rows()), -1);
  for (const std::int32_t corner : mesh.triangles.reshaped())
    names[static_cast<std::size_t>(corner)] = 0;
  std::int32_t next = 0;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == 0) {
      mesh.points.row(next) = mesh.points.row(static_cast<Eigen::Index>(i)).eval();
      names[i] = next++;
    }
  mesh.points.conservativeResize(next, 3);
  mesh.triangles =
      mesh.triangles.unaryExpr([&](std::int32_t corner) { return names[static_cast<std::size_t>(corner)]; })
          .eval();
}

/// The triangle across each edge of each triangle, where there is exactly one, and whether it runs through
/// the edge in the same direction, which means that one of the two is turned around.
class Neighbours {
public:
  explicit Neighbours(const Triangles& triangles) : across_(static_cast<std::size_t>(triangles.size())) {
    forEachEdge(triangles, [&](std::span<const EdgeUse> uses) {
      if (uses.size() != 2)
        return;
      const bool same = uses[0].forward == uses[1].forward;
      across_[std::size_t(uses[0].side)] = {uses[1].side / 3, same};
      across_[std::size_t(uses[1].side)] = {uses[0].side / 3, same};
    });
  }

  struct Across {
    std::int32_t triangle = -1;
    bool disagrees = false;
  };
  const Across& of(std::int32_t triangle, int side) const {
    return across_[static_cast<std::size_t>(3 * triangle + side)];
  }

private:
  std::vector<Across> across_;
};

/// Turns triangles until neighbours agree; of a piece the smaller area. The number turned.
int agree(TriangleMesh& mesh) {
  const Neighbours neighbours(mesh.triangles);
  std::vector<signed char> turned(static_cast<std::size_t>(mesh.triangles.rows()), -1);
  int count = 0;
  for (std::int32_t seed = 0; seed < static_cast<std::int32_t>(mesh.triangles.rows()); ++seed) {
    if (turned[static_cast<std::size_t>(seed)] >= 0)
      continue;
    std::vector<std::int32_t> piece = {seed};
    turned[static_cast<std::size_t>(seed)] = 0;
    std::array<double, 2> area = {0, 0};
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const signed char mine = turned[static_cast<std::size_t>(piece[i])];
      area[static_cast<std::size_t>(mine)] += areaOf(mesh.points, mesh.triangles, piece[i]);
      for (int side = 0; side < 3; ++side) {
        const auto& [other, disagrees] = neighbours.of(piece[i], side);
        if (other < 0 || turned[static_cast<std::size_t>(other)] >= 0)
          continue;
        turned[static_cast<std::size_t>(other)] = disagrees ? 1 - mine : mine;
        piece.push_back(other);
      }
    }
    const signed char wrong = area[1] > area[0] ? 0 : 1;
    for (const std::int32_t t : piece)
      if (turned[static_cast<std::size_t>(t)] == wrong) {
        std::swap(mesh.triangles(t, 1), mesh.triangles(t, 2));
        ++count;
      }
  }
  return count;
}

/// About the mean of the points, so that it means something for an open surface as well.
double signedVolume(const TriangleMesh& mesh) {
  if (mesh.points.rows() == 0)
    return 0;
  const Points around = mesh.points.rowwise() - mesh.points.colwise().mean();
  double sum = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    sum += around.row(mesh.triangles(t, 0))
               .dot(around.row(mesh.triangles(t, 1)).cross(around.row(mesh.triangles(t, 2))));
  return sum;
}

} // namespace

int faceOutward(TriangleMesh& mesh) {
  const int turned = agree(mesh);
  if (signedVolume(mesh) >= 0)
    return turned;
  mesh.triangles.col(1).swap(mesh.triangles.col(2));
  return static_cast<int>(mesh.triangles.rows()) - turned;
}

CleanedSurface cleanSurface(const TriangleMesh& mesh) {
  CleanedSurface result;
  result.mesh.points = mesh.points;
  result.mesh.triangles = mesh.triangles;
  const Renaming renaming = mergeNear(mesh.points, kMergeDistance * boundsOf(mesh.points).diagonal());
  result.mergedPoints = static_cast<int>(mesh.points.rows()) - renaming.count;
  if (result.mergedPoints > 0) {
    for (Eigen::Index i = mesh.points.rows(); i-- > 0;) // Backwards: the first of equals keeps its place.
      result.mesh.points.row(renaming.names[static_cast<std::size_t>(i)]) = mesh.points.row(i);
    result.mesh.points.conservativeResize(renaming.count, 3);
    for (std::int32_t& corner : result.mesh.triangles.reshaped())
      corner = renaming.names[static_cast<std::size_t>(corner)];
  }
  dropUseless(result.mesh, true);
  dropUnusedPoints(result.mesh);
  result.removedTriangles = static_cast<int>(mesh.triangles.rows() - result.mesh.triangles.rows());
  result.turnedTriangles = faceOutward(result.mesh);
  return result;
}

TriangleMesh clusterVertices(const TriangleMesh& mesh, double cell) {
  const Bounds box = boundsOf(mesh.points);
  const auto width = static_cast<std::int64_t>(std::floor((box.high - box.low).maxCoeff() / cell)) + 1;
  std::unordered_map<std::int64_t, std::int32_t> clusters;
  std::vector<std::int32_t> names;
  std::vector<std::pair<Vec3, int>> sums;
  for (Eigen::Index i = 0; i < mesh.points.rows(); ++i) {
    const Vec3 place = (mesh.points.row(i).transpose() - box.low) / cell;
    const auto key =
        (static_cast<std::int64_t>(place[2]) * width + static_cast<std::int64_t>(place[1])) * width +
        static_cast<std::int64_t>(place[0]);
    const auto [entry, fresh] = clusters.try_emplace(key, static_cast<std::int32_t>(sums.size()));
    if (fresh)
      sums.push_back({Vec3::Zero(), 0});
    auto& [sum, count] = sums[static_cast<std::size_t>(entry->second)];
    sum += mesh.points.row(i).transpose();
    ++count;
    names.push_back(entry->second);
  }
  TriangleMesh coarse;
  coarse.points.resize(static_cast<Eigen::Index>(sums.size()), 3);
  for (std::size_t i = 0; i < sums.size(); ++i)
    coarse.points.row(static_cast<Eigen::Index>(i)) = sums[i].first.transpose() / sums[i].second;
  coarse.triangles =
      mesh.triangles.unaryExpr([&](std::int32_t corner) { return names[static_cast<std::size_t>(corner)]; });
  dropUseless(coarse, false); // Repeated ones count: winding numbers add up.
  return coarse;
}

} // namespace viscera::geometry
