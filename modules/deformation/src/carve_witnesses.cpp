#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "tetrahedron_faces.h"
#include "viscera/deformation/witness_mesh.h"
#include "viscera/geometry/signed_distance.h"
#include "viscera/geometry/winding_number.h"

// Tetrahedra are cut along a cavity's wall. Each edge through the wall gets a point on it; what is left of a
// tetrahedron is split again from its lowest corners ("pulling"), so that neighbours split their common face
// alike and the mesh stays whole.
namespace viscera::deformation {
namespace {

using Surface = std::shared_ptr<const geometry::TriangleMesh>;
using Corner = std::int32_t;
using Polygon = std::vector<Corner>;
using Tetrahedron = std::array<Corner, 4>;

constexpr Eigen::Index kCarvedAtOnce = 1024;
constexpr Eigen::Index kWallGrain = 128;
/// A corner that is nearer to the wall than this part of an edge that goes through it counts as on the wall:
/// slivers are kept out.
constexpr double kSnap = 0.06;
/// Pieces of a tetrahedron that are smaller than this fraction of it count as flat.
constexpr double kFlatPart = 1e-6;
/// Steps by the false position from the first guess of a point on the wall.
constexpr int kWallSteps = 2;

/// Tells which of the points are inside a cavity.
std::vector<char> insideOf(const Points& points, const geometry::TriangleMesh& cavity, Threads threads) {
  std::vector<char> inside(static_cast<std::size_t>(points.rows()), 0);
  const geometry::WindingNumber winding(cavity);
  const Bounds box = boundsOf(cavity.points);
  parallelRanges(points.rows(), kCarvedAtOnce, threads, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index i = begin; i < end; ++i) {
      const Vec3 at = points.row(i).transpose();
      const bool near = (at.array() >= box.low.array()).all() && (at.array() <= box.high.array()).all();
      if (near && winding.inside(at))
        inside[static_cast<std::size_t>(i)] = 1;
    }
  });
  return inside;
}

/// Splits a convex body, given by its faces (outward), from its lowest corner.
void split(const std::vector<Polygon>& faces, std::vector<Tetrahedron>& pieces) {
  Corner apex = faces.front().front();
  for (const Polygon& face : faces)
    apex = std::min(apex, *std::min_element(face.begin(), face.end()));
  for (const Polygon& face : faces) {
    if (std::find(face.begin(), face.end(), apex) != face.end())
      continue;
    const auto count = face.size();
    const auto first = static_cast<std::size_t>(std::min_element(face.begin(), face.end()) - face.begin());
    for (std::size_t k = 1; k + 1 < count; ++k)
      pieces.push_back({apex, face[first], face[(first + k) % count], face[(first + k + 1) % count]});
  }
}

/// Cuts one cavity out of tetrahedra.
class Carver {
public:
  Carver(const Surface& cavity, const Points& points, const std::vector<Tetrahedron>& tetrahedra,
         const std::vector<char>& inside, Threads threads)
      : wall_(cavity), points_(points), tetrahedra_(tetrahedra), inside_(inside), threads_(threads),
        distance_(static_cast<std::size_t>(points.rows()), 0),
        side_(static_cast<std::size_t>(points.rows()), 1) {
    measure();
    settle();
  }

  bool straddles(const Tetrahedron& tetrahedron) const {
    int in = 0;
    for (const Corner corner : tetrahedron)
      in += inside_[std::size_t(corner)];
    return in > 0 && in < 4;
  }

  /// Adds what is left of a straddling tetrahedron.
  void cut(const Tetrahedron& tetrahedron, std::vector<Tetrahedron>& left) {
    int lowest = 1, highest = -1;
    for (const Corner corner : tetrahedron) {
      lowest = std::min(lowest, sideOf(corner));
      highest = std::max(highest, sideOf(corner));
    }
    if (highest <= 0)
      return;
    if (lowest >= 0)
      return left.push_back(tetrahedron);
    std::vector<Polygon> faces;
    std::map<Corner, Corner> around; // The edges of the face on the wall, each to the next corner.
    for (const auto& corners : kFaces) {
      Polygon face = clipped(tetrahedron, corners);
      if (face.size() < 3)
        continue;
      for (std::size_t k = 0; k < face.size(); ++k) {
        const Corner from = face[k], to = face[(k + 1) % face.size()];
        if (onWall(from) && onWall(to))
          around[to] = from;
      }
      faces.push_back(std::move(face));
    }
    Polygon wall;
    if (!around.empty())
      for (Corner at = around.begin()->first; wall.size() < around.size();) {
        wall.push_back(at);
        const auto next = around.find(at);
        at = next == around.end() ? around.begin()->first : next->second;
      }
    if (wall.size() >= 3)
      faces.push_back(std::move(wall));
    split(faces, left);
  }

  /// The points that were made on the wall, in the order of their numbers, which go on from the mesh's.
  Points made() const {
    Points points(static_cast<Eigen::Index>(edges_.size()), 3);
    parallelRanges(points.rows(), kWallGrain, threads_, [&](Eigen::Index begin, Eigen::Index end) {
      for (Eigen::Index i = begin; i < end; ++i)
        points.row(i) = crossing(edges_[static_cast<std::size_t>(i)]).transpose();
    });
    return points;
  }

private:
  using Edge = std::pair<Corner, Corner>;

  /// Distances from the wall where they are needed, negative in the cavity.
  void measure() {
    std::vector<char> wanted(side_.size(), 0);
    for (const Tetrahedron& tetrahedron : tetrahedra_)
      if (straddles(tetrahedron))
        for (const Corner corner : tetrahedron)
          wanted[std::size_t(corner)] = 1;
    std::vector<Corner> list;
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (wanted[i] != 0)
        list.push_back(static_cast<Corner>(i));
    parallelRanges(static_cast<Eigen::Index>(list.size()), kWallGrain, threads_,
                   [&](Eigen::Index begin, Eigen::Index end) {
                     for (Eigen::Index i = begin; i < end; ++i) {
                       const Corner corner = list[static_cast<std::size_t>(i)];
                       const Vec3 at = points_.row(corner).transpose();
                       const double away = (wall_.nearest(at) - at).norm();
                       distance_[std::size_t(corner)] = inside_[std::size_t(corner)] != 0 ? -away : away;
                     }
                   });
  }

  /// Says on which side each corner counts.
  void settle() {
    for (std::size_t i = 0; i < side_.size(); ++i)
      side_[i] = inside_[i] != 0 ? -1 : 1;
    for (const Tetrahedron& tetrahedron : tetrahedra_) {
      if (!straddles(tetrahedron))
        continue;
      for (const Corner a : tetrahedron)
        for (const Corner b : tetrahedron)
          if (inside_[std::size_t(a)] == 0 && inside_[std::size_t(b)] != 0) {
            const double part = firstGuess({a, b});
            if (part < kSnap)
              side_[std::size_t(a)] = 0;
            else if (part > 1 - kSnap)
              side_[std::size_t(b)] = 0;
          }
    }
  }

  int sideOf(Corner corner) const { return side_[std::size_t(corner)]; }
  bool onWall(Corner corner) const {
    return corner >= static_cast<Corner>(side_.size()) || sideOf(corner) == 0;
  }

  /// How far along an edge the wall is, were the distance linear.
  double firstGuess(const Edge& edge) const {
    const double from = distance_[std::size_t(edge.first)], to = distance_[std::size_t(edge.second)];
    return from == to ? 0.5 : std::clamp(from / (from - to), 0.0, 1.0);
  }

  Vec3 crossing(const Edge& edge) const {
    const Vec3 a = points_.row(edge.first).transpose(), b = points_.row(edge.second).transpose();
    double low = 0, high = 1;
    double lowDistance = distance_[std::size_t(edge.first)],
           highDistance = distance_[std::size_t(edge.second)];
    double part = firstGuess(edge);
    for (int step = 0; step < kWallSteps; ++step) {
      const double distance = wall_(a + part * (b - a));
      const bool before = (distance > 0) == (lowDistance > 0); // Of the same side as the edge's beginning.
      (before ? low : high) = part;
      (before ? lowDistance : highDistance) = distance;
      if (lowDistance == highDistance)
        break;
      // The false position: d is taken for linear between the two ends, d_low / (d_low - d_high) of the way.
      part = low + (high - low) * std::clamp(lowDistance / (lowDistance - highDistance), 0.0, 1.0);
    }
    part = std::clamp(part, 0.5 * kSnap, 1 - 0.5 * kSnap);
    return a + part * (b - a);
  }

  Corner pointOn(Corner a, Corner b) {
    const Edge edge = std::minmax(a, b);
    const std::int64_t key = (static_cast<std::int64_t>(edge.first) << 32) | edge.second;
    const auto [place, isNew] = numbers_.try_emplace(key, static_cast<Corner>(side_.size() + edges_.size()));
    if (isNew)
      edges_.push_back(edge);
    return place->second;
  }

  Polygon clipped(const Tetrahedron& tetrahedron, const std::array<int, 3>& corners) {
    Polygon face;
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner a = tetrahedron[std::size_t(corners[k])];
      const Corner b = tetrahedron[std::size_t(corners[(k + 1) % 3])];
      if (sideOf(a) >= 0)
        face.push_back(a);
      if (sideOf(a) * sideOf(b) < 0)
        face.push_back(pointOn(a, b));
    }
    return face;
  }

  geometry::SignedDistance wall_;
  const Points& points_;
  const std::vector<Tetrahedron>& tetrahedra_;
  const std::vector<char>& inside_;
  Threads threads_;
  std::vector<double> distance_;
  std::vector<int> side_; ///< 1 in the tissue, 0 on the wall, -1 in the cavity.
  std::unordered_map<std::int64_t, Corner> numbers_;
  std::vector<Edge> edges_; ///< Of the points on the wall.
};

/// The mesh while cavities are taken out of it, one after the other.
struct Carving {
  Points points;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<char> inBlood; ///< Of the mesh's own points.
  bool changed = false;

  explicit Carving(const WitnessMesh& mesh)
      : points(mesh.points), inBlood(static_cast<std::size_t>(mesh.points.rows()), 0) {
    for (Eigen::Index t = 0; t < mesh.tetrahedra.rows(); ++t)
      tetrahedra.push_back(
          {mesh.tetrahedra(t, 0), mesh.tetrahedra(t, 1), mesh.tetrahedra(t, 2), mesh.tetrahedra(t, 3)});
  }

  double volumeOf(const Tetrahedron& t) const {
    const Eigen::RowVector3d a = points.row(t[0]);
    return (points.row(t[1]) - a).cross(points.row(t[2]) - a).dot(points.row(t[3]) - a) / 6;
  }

  /// A cavity so narrow that it has no corner inside is found by the middles.
  std::vector<char> middlesInside(const geometry::TriangleMesh& cavity, Threads threads) const {
    Points middles = Points::Zero(static_cast<Eigen::Index>(tetrahedra.size()), 3);
    for (std::size_t t = 0; t < tetrahedra.size(); ++t)
      for (const Corner corner : tetrahedra[t])
        middles.row(static_cast<Eigen::Index>(t)) += 0.25 * points.row(corner);
    return insideOf(middles, cavity, threads);
  }

  void takeOut(const Surface& cavity, Threads threads) {
    const std::vector<char> inside = insideOf(points, *cavity, threads);
    for (std::size_t i = 0; i < inBlood.size(); ++i)
      inBlood[i] = inBlood[i] != 0 || inside[i] != 0;
    const std::vector<char> middles = middlesInside(*cavity, threads);
    Carver carver(cavity, points, tetrahedra, inside, threads);
    std::vector<Tetrahedron> left;
    std::vector<std::pair<std::size_t, double>> cut; // Where pieces begin, and the volume they are of.
    for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
      if (carver.straddles(tetrahedra[t])) {
        cut.emplace_back(left.size(), volumeOf(tetrahedra[t]));
        carver.cut(tetrahedra[t], left);
        cut.emplace_back(left.size(), 0);
      } else if (inside[std::size_t(tetrahedra[t][0])] == 0 && middles[t] == 0) {
        left.push_back(tetrahedra[t]);
      } else {
        changed = true;
      }
    }
    changed = changed || !cut.empty();
    const Points made = carver.made();
    points.conservativeResize(points.rows() + made.rows(), Eigen::NoChange);
    points.bottomRows(made.rows()) = made;
    dropFlat(left, cut);
  }

  void dropFlat(const std::vector<Tetrahedron>& left,
                const std::vector<std::pair<std::size_t, double>>& cut) {
    tetrahedra.clear();
    std::size_t next = 0;
    double least = 0;
    for (std::size_t t = 0; t < left.size(); ++t) {
      for (; next < cut.size() && cut[next].first <= t; ++next)
        least = kFlatPart * cut[next].second;
      if (least == 0 || volumeOf(left[t]) > least)
        tetrahedra.push_back(left[t]);
    }
  }
};

} // namespace

WitnessMesh withoutCavities(const WitnessMesh& mesh, const std::vector<Surface>& cavities, Threads threads) {
  Carving carving(mesh);
  for (const Surface& cavity : cavities)
    carving.takeOut(cavity, threads);
  std::vector<Corner> number(static_cast<std::size_t>(carving.points.rows()), -1);
  for (const Tetrahedron& tetrahedron : carving.tetrahedra)
    for (const Corner corner : tetrahedron)
      number[std::size_t(corner)] = 0;
  WitnessMesh carved;
  Corner points = 0;
  for (const bool wanted : {true, false})
    for (Eigen::Index point = 0; point < carving.points.rows(); ++point) {
      const auto at = static_cast<std::size_t>(point);
      const bool witness = mesh.isWitness(point) && carving.inBlood[at] == 0;
      if (number[at] >= 0 && witness == wanted) {
        number[at] = points++;
        carved.witnesses += wanted ? 1 : 0;
      }
    }
  if (!carving.changed || carved.witnesses == 0)
    return mesh;
  carved.points.resize(points, 3);
  for (Eigen::Index point = 0; point < carving.points.rows(); ++point)
    if (const Corner row = number[static_cast<std::size_t>(point)]; row >= 0)
      carved.points.row(row) = carving.points.row(point);
  carved.tetrahedra.resize(static_cast<Eigen::Index>(carving.tetrahedra.size()), 4);
  for (std::size_t t = 0; t < carving.tetrahedra.size(); ++t)
    for (std::size_t k = 0; k < 4; ++k)
      carved.tetrahedra(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(k)) =
          number[std::size_t(carving.tetrahedra[t][k])];
  return carved;
}

} // namespace viscera::deformation
