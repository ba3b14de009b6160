#include "viscera/geometry/tube_axis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "viscera/core/disjoint_sets.h"
#include "viscera/core/error.h"
#include "viscera/geometry/volume.h"

namespace viscera::geometry {
namespace {

/// Parts of the longest way along the surface: around a tip nothing is farther than it within the first;
/// the surface within the second tells a wide end from a narrow one; the harmonic function is fixed within
/// the third.
constexpr double kTipReach = 0.12;
constexpr double kEndReach = 0.15;
constexpr double kFixedReach = 0.03;
/// Points of the centreline are that far from each other at least.
constexpr double kApart = 1.0 / 30;

using Neighbors = std::vector<std::vector<std::pair<int, double>>>;

Neighbors neighborsOf(const TriangleMesh& mesh) {
  Neighbors neighbors(static_cast<std::size_t>(mesh.points.rows()));
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.triangles(t, k);
      const int b = mesh.triangles(t, (k + 1) % 3);
      // Every edge of a closed oriented surface comes once in each direction.
      neighbors[static_cast<std::size_t>(a)].emplace_back(b,
                                                          (mesh.points.row(a) - mesh.points.row(b)).norm());
    }
  return neighbors;
}

Values distancesFrom(const Neighbors& neighbors, const std::vector<int>& sources, double reach) {
  Values distances =
      Values::Constant(static_cast<Eigen::Index>(neighbors.size()), std::numeric_limits<double>::infinity());
  using Item = std::pair<double, int>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  for (const int source : sources) {
    distances[source] = 0;
    queue.emplace(0, source);
  }
  while (!queue.empty()) {
    const auto [distance, vertex] = queue.top();
    queue.pop();
    if (distance > distances[vertex])
      continue;
    for (const auto& [next, length] : neighbors[static_cast<std::size_t>(vertex)])
      if (const double there = distance + length; there < distances[next] && there <= reach) {
        distances[next] = there;
        queue.emplace(there, next);
      }
  }
  return distances;
}

constexpr double kEverywhere = std::numeric_limits<double>::infinity();

int farthest(const Values& distances) {
  Eigen::Index vertex = 0;
  double most = -1;
  for (Eigen::Index i = 0; i < distances.size(); ++i)
    if (std::isfinite(distances[i]) && distances[i] > most) {
      most = distances[i];
      vertex = i;
    }
  return static_cast<int>(vertex);
}

double finiteMost(const Values& distances) {
  return distances[farthest(distances)];
}

/// The places that are farther from `distances`' source than all within `reach` of them, farthest first.
std::vector<int> tipsOf(const Neighbors& neighbors, const Values& distances, double reach) {
  std::vector<int> order;
  for (Eigen::Index i = 0; i < distances.size(); ++i)
    if (std::isfinite(distances[i]) && distances[i] > reach)
      order.push_back(static_cast<int>(i));
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return std::pair(-distances[a], a) < std::pair(-distances[b], b); });
  std::vector<bool> seen(neighbors.size(), false);
  std::vector<int> tips;
  for (const int vertex : order) {
    if (seen[static_cast<std::size_t>(vertex)])
      continue;
    const bool local = std::all_of(neighbors[static_cast<std::size_t>(vertex)].begin(),
                                   neighbors[static_cast<std::size_t>(vertex)].end(), [&](const auto& next) {
                                     return distances[next.first] <= distances[vertex];
                                   });
    if (!local)
      continue;
    const Values around = distancesFrom(neighbors, {vertex}, reach);
    bool tip = true;
    for (Eigen::Index i = 0; i < around.size(); ++i)
      if (std::isfinite(around[i])) {
        seen[static_cast<std::size_t>(i)] = true;
        tip = tip && distances[i] <= distances[vertex];
      }
    if (tip)
      tips.push_back(vertex);
  }
  return tips;
}

double areaWithin(const TriangleMesh& mesh, const Values& distances) {
  double area = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto corner = mesh.triangles.row(t);
    if (std::isfinite(distances[corner[0]] + distances[corner[1]] + distances[corner[2]]))
      area += areaOf(mesh.points, mesh.triangles, t);
  }
  return area;
}

/// The function that is 0 around one vertex, 1 around another and harmonic in between. Cotangent weights,
/// kept positive, so that it has no extremum of its own on bad triangles either.
Values harmonic(const TriangleMesh& mesh, const Values& fromOne, const Values& fromOther, double reach) {
  const Eigen::Index n = mesh.points.rows();
  Values values = Values::Zero(n);
  std::vector<int> unknown(static_cast<std::size_t>(n), -1);
  int count = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    if (fromOther[i] <= reach)
      values[i] = 1;
    else if (fromOne[i] > reach && std::isfinite(fromOne[i]))
      unknown[static_cast<std::size_t>(i)] = count++;
  }
  std::vector<Eigen::Triplet<double>> entries;
  Values right = Values::Zero(count);
  constexpr double kLeastWeight = 1e-3;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int c = mesh.triangles(t, k);
      const int a = mesh.triangles(t, (k + 1) % 3);
      const int b = mesh.triangles(t, (k + 2) % 3);
      const Vec3 u = (mesh.points.row(a) - mesh.points.row(c)).transpose();
      const Vec3 v = (mesh.points.row(b) - mesh.points.row(c)).transpose();
      const double area2 = u.cross(v).norm();
      // The sum of (cot alpha + cot beta) / 2 (u_a - u_b) over the edges of a free vertex is 0, the angles
      // opposite to the edge; cot = u . v / |u x v|. The halves drop out.
      const double weight = std::clamp(area2 > 0 ? u.dot(v) / area2 : 0.0, kLeastWeight, 1 / kLeastWeight);
      for (const auto& [row, other] : {std::pair(a, b), std::pair(b, a)}) {
        const int i = unknown[static_cast<std::size_t>(row)];
        if (i < 0)
          continue;
        entries.emplace_back(i, i, weight);
        if (const int j = unknown[static_cast<std::size_t>(other)]; j >= 0)
          entries.emplace_back(i, j, -weight);
        else
          right[i] += weight * values[other];
      }
    }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  const Values solution = solver.solve(right);
  if (solver.info() != Eigen::Success || !solution.allFinite())
    throw DataError("no harmonic function can be found on the surface", "centreline", "repair the surface");
  for (Eigen::Index i = 0; i < n; ++i)
    if (const int k = unknown[static_cast<std::size_t>(i)]; k >= 0)
      values[i] = solution[k];
  return values;
}

/// One loop of a slice: its centre and area.
struct Slice {
  Vec3 center = Vec3::Zero();
  double area = 0;
};

/// Cuts the surface where `values` is `level`; of several loops the one around the largest area.
class Slicer {
public:
  Slicer(const TriangleMesh& mesh, const Values& values) : mesh_(mesh), values_(values) {}

  Slice at(double level) {
    level_ = level;
    segments_.clear();
    ends_.clear();
    for (Eigen::Index t = 0; t < mesh_.triangles.rows(); ++t)
      cut(t);
    return largestLoop();
  }

private:
  struct Segment {
    Vec3 from, to;
    int loop = -1;
    std::array<int, 2> points{};
  };

  bool above(int vertex) const { return values_[vertex] >= level_; }

  /// The number of the point where the edge crosses the level, shared by both its triangles.
  int crossing(int a, int b, Vec3& place) {
    const double part = (level_ - values_[a]) / (values_[b] - values_[a]);
    place = ((1 - part) * mesh_.points.row(a) + part * mesh_.points.row(b)).transpose();
    return ends_.try_emplace(std::minmax(a, b), static_cast<int>(ends_.size())).first->second;
  }

  void cut(Eigen::Index t) {
    Segment segment;
    int found = 0;
    for (int k = 0; k < 3; ++k) {
      const int a = mesh_.triangles(t, k);
      const int b = mesh_.triangles(t, (k + 1) % 3);
      if (above(a) == above(b))
        continue;
      // One edge goes up and one goes down: so all segments run around the same way.
      const int low = std::min(a, b);
      const int high = std::max(a, b);
      if (above(b))
        segment.points[0] = crossing(low, high, segment.from);
      else
        segment.points[1] = crossing(low, high, segment.to);
      ++found;
    }
    if (found == 2)
      segments_.push_back(segment);
  }

  Slice largestLoop() {
    DisjointSets points(ends_.size());
    for (const Segment& segment : segments_)
      points.join(static_cast<std::size_t>(segment.points[0]), static_cast<std::size_t>(segment.points[1]));
    std::map<std::size_t, std::vector<const Segment*>> loops;
    for (const Segment& segment : segments_)
      loops[points.root(static_cast<std::size_t>(segment.points[0]))].push_back(&segment);
    Slice best;
    for (const auto& [number, loop] : loops)
      if (const Slice slice = sliceOf(loop); slice.area > best.area)
        best = slice;
    return best;
  }

  /// The loop as a fan of triangles around its middle.
  static Slice sliceOf(const std::vector<const Segment*>& loop) {
    Vec3 middle = Vec3::Zero();
    for (const Segment* segment : loop)
      middle += segment->from / static_cast<double>(loop.size());
    Vec3 normal = Vec3::Zero();
    for (const Segment* segment : loop)
      normal += 0.5 * (segment->from - middle).cross(segment->to - middle);
    Slice slice{middle, normal.norm()};
    if (!(slice.area > 0))
      return slice;
    // c = sum A_i c_i / A with the fan's triangles, A_i their signed areas along the loop's area vector: a
    // part of a dented loop that the fan covers twice counts once.
    Vec3 moment = Vec3::Zero();
    for (const Segment* segment : loop) {
      const double part = 0.5 * (segment->from - middle).cross(segment->to - middle).dot(normal) / slice.area;
      moment += part * (segment->from - middle + (segment->to - middle)) / 3;
    }
    slice.center = middle + moment / slice.area;
    return slice;
  }

  const TriangleMesh& mesh_;
  const Values& values_;
  double level_ = 0;
  std::vector<Segment> segments_;
  std::map<std::pair<int, int>, int> ends_;
};

/// Levels with about as many free vertices between any two of them.
std::vector<double> evenLevels(const Values& values, int count) {
  std::vector<double> inside;
  for (Eigen::Index i = 0; i < values.size(); ++i)
    if (values[i] > 0 && values[i] < 1)
      inside.push_back(values[i]);
  std::sort(inside.begin(), inside.end());
  std::vector<double> levels;
  for (int k = 0; k < count && !inside.empty(); ++k) {
    const double place = (k + 0.5) / count * static_cast<double>(inside.size());
    levels.push_back(inside[std::min(inside.size() - 1, static_cast<std::size_t>(place))]);
  }
  return levels;
}

} // namespace

TubeEnds tubeEnds(const TriangleMesh& mesh) {
  const Neighbors neighbors = neighborsOf(mesh);
  const int one = farthest(distancesFrom(neighbors, {0}, kEverywhere));
  const Values fromOne = distancesFrom(neighbors, {one}, kEverywhere);
  const int other = farthest(fromOne);
  const double length = fromOne[other];
  // A tip beside the one that is looked from lies on the way to farther places: so look from both ends.
  std::vector<int> tips = tipsOf(neighbors, fromOne, kTipReach * length);
  for (const int tip : tipsOf(neighbors, distancesFrom(neighbors, {other}, kEverywhere), kTipReach * length))
    tips.push_back(tip);
  TubeEnds ends;
  double most = -1;
  for (const int tip : tips) {
    const double area = areaWithin(mesh, distancesFrom(neighbors, {tip}, kEndReach * length));
    if (area > most) {
      most = area;
      ends.wide = tip;
    }
  }
  ends.narrow = farthest(distancesFrom(neighbors, {ends.wide}, kEverywhere));
  return ends;
}

int tipBeyond(const TriangleMesh& mesh, int vertex, int other) {
  const Neighbors neighbors = neighborsOf(mesh);
  const Values fromOther = distancesFrom(neighbors, {other}, kEverywhere);
  const Values fromVertex = distancesFrom(neighbors, {vertex}, kEverywhere);
  const std::vector<int> tips = tipsOf(neighbors, fromOther, kTipReach * finiteMost(fromOther));
  int best = farthest(fromOther);
  for (const int tip : tips)
    if (fromVertex[tip] < fromVertex[best])
      best = tip;
  return best;
}

TubeAxis tubeAxis(const TriangleMesh& mesh, int from, int to, int slices) {
  const Neighbors neighbors = neighborsOf(mesh);
  const Values fromOne = distancesFrom(neighbors, {from}, kEverywhere);
  const Values fromOther = distancesFrom(neighbors, {to}, kEverywhere);
  const double length = fromOne[to];
  if (!(length > 0) || !std::isfinite(length))
    throw DataError(length == 0 ? "its two ends are at one place" : "its two ends are on separate pieces",
                    "centreline", "choose two ends of one surface");
  const Values values = harmonic(mesh, fromOne, fromOther, kFixedReach * length);
  TubeAxis axis;
  axis.points.push_back(mesh.points.row(from).transpose());
  axis.areas.push_back(0);
  Slicer slicer(mesh, values);
  for (const double level : evenLevels(values, slices)) {
    const Slice slice = slicer.at(level);
    // Centres at the mouth of a side branch go aside and back by less than this.
    if (!(slice.area > 0) || (slice.center - axis.points.back()).norm() < kApart * length)
      continue;
    axis.points.push_back(slice.center);
    axis.areas.push_back(slice.area);
  }
  axis.points.push_back(mesh.points.row(to).transpose());
  axis.areas.push_back(0);
  return axis;
}

} // namespace viscera::geometry
