#include "surface/remesh.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "viscera/geometry/editable_surface.h"

namespace viscera::sample_organs {
namespace {

using geometry::EditableSurface;
using geometry::TriangleMesh;
using Edge = EditableSurface::Edge;
using Index = EditableSurface::Index;

constexpr double kSplitAbove = 4.0 / 3.0;
constexpr double kCollapseBelow = 4.0 / 5.0;
constexpr int kFewestRounds = 7;
constexpr int kMostRounds = 16;
constexpr int kSettlingRounds = 2; // before the count says anything about the length
constexpr int kFinishingRounds = 5;
constexpr double kCountTolerance = 0.02;
constexpr double kLengthExponent =
    0.4;                         // below 1/2, which would be exact, so that the count does not oscillate
constexpr double kGrowth = 1.25; // edge scale from one vertex to the next
constexpr int kGradingPasses = 4;
constexpr double kSlopeProbe = 0.02; // mm
constexpr double kLeastSlope = 0.25; // below this the mesh's normal is no direction to search along
constexpr Eigen::Index kRemeshedAtOnce = 512;

std::size_t at(Index index) {
  return static_cast<std::size_t>(index);
}

enum class Onto { nothing, nearSurface, surface };

class Remesher {
public:
  Remesher(const TriangleMesh& mesh, const ImplicitNode& node, Threads threads)
      : surface_(mesh), node_(node), threads_(threads), scale_(at(surface_.vertexCount()), 1.0) {
    readScales();
    uniform_ = std::all_of(scale_.begin(), scale_.end(), [](double scale) { return scale == 1; });
  }

  TriangleMesh run(int wanted, Progress& progress) {
    double length = lengthFor(wanted);
    for (int round = 0; round < kMostRounds; ++round) {
      progress.throwIfCancelled();
      progress.report(static_cast<double>(round) / (kMostRounds + kFinishingRounds));
      if (!uniform_ && round > 0)
        readScales();
      splitLong(length);
      collapseShort(length);
      flipAll();
      relax(0.8, Onto::nothing);
      relax(0.8, Onto::nearSurface);
      const double excess = static_cast<double>(surface_.triangleCount()) / wanted;
      if (round + 1 >= kFewestRounds && std::abs(excess - 1) < kCountTolerance)
        break;
      if (round >= kSettlingRounds)
        length *= std::pow(excess, kLengthExponent);
    }
    for (int round = 0; round < kFinishingRounds; ++round) {
      progress.throwIfCancelled();
      progress.report(static_cast<double>(kMostRounds + round) / (kMostRounds + kFinishingRounds));
      flipAll();
      relax(0.6, Onto::surface);
    }
    return surface_.mesh();
  }

private:
  double scaleOf(const Edge& edge) const { return 0.5 * (scale_[at(edge.a)] + scale_[at(edge.b)]); }

  /// The edge length that covers the surface with that many triangles: N triangles of area
  /// sqrt(3) / 4 (L h)^2, where h is the scale, cover it when sum A / h^2 = sqrt(3) / 4 N L^2. A third of
  /// each triangle counts with the scale of each corner.
  double lengthFor(int wanted) const {
    double covered = 0;
    for (const Index v : surface_.vertices())
      for (const Index t : surface_.trianglesAround(v))
        covered += surface_.doubleArea(t).norm() / 6 / (scale_[at(v)] * scale_[at(v)]);
    return std::sqrt(covered / (kTriangleArea * wanted));
  }

  /// The node's scales, none above `kGrowth` times a neighbour's as far as the passes reach: h_v <= g h_u.
  void readScales() {
    forEachVertex([this](Index v) { scale_[at(v)] = node_.shade(surface_.point(v)).edgeScale; });
    for (int pass = 0; pass < kGradingPasses && !uniform_; ++pass) {
      const std::vector<double> before = scale_;
      forEachVertex([&](Index v) {
        for (const Index t : surface_.trianglesAround(v))
          for (const Index u : surface_.corners(t))
            scale_[at(v)] = std::min(scale_[at(v)], kGrowth * before[at(u)]);
      });
    }
  }

  /// Edges with |e| >= 4/3 L h_e, where h_e = (h_a + h_b) / 2: halved, both parts are no farther from
  /// L h_e than the whole was.
  void splitLong(double length) {
    for (const Edge& edge : surface_.edges()) {
      const double longest = kSplitAbove * length * scaleOf(edge);
      if (surface_.length2(edge) < longest * longest)
        continue;
      if (surface_.split(edge) >= 0)
        scale_.push_back(scaleOf(edge));
    }
  }

  /// Edges with |e| < 4/5 L h_e, unless the new vertex would have an edge above 4/3 L h_e, which the next
  /// round would split again.
  void collapseShort(double length) {
    struct Short {
      Edge edge;
      double relative2;
    };
    std::vector<Short> list;
    for (const Edge& edge : surface_.edges()) {
      const double wanted = length * scaleOf(edge);
      const double relative2 = surface_.length2(edge) / (wanted * wanted);
      if (relative2 < kCollapseBelow * kCollapseBelow)
        list.push_back({edge, relative2});
    }
    // Shortest first; equal ones in the order of the triangles, so that the result is the same everywhere.
    std::stable_sort(list.begin(), list.end(),
                     [](const Short& x, const Short& y) { return x.relative2 < y.relative2; });
    for (const Short& item : list) {
      const double scale = scaleOf(item.edge);
      const double shortest = kCollapseBelow * length * scale;
      if (!surface_.exists(item.edge.a) || !surface_.exists(item.edge.b))
        continue;
      if (surface_.length2(item.edge) > shortest * shortest)
        continue;
      if (surface_.collapse(item.edge, kSplitAbove * length * scale))
        scale_[at(item.edge.a)] = scale;
    }
  }

  /// Edges whose flip makes sum (valence - 6)^2 over the two ends and the two opposite corners smaller.
  void flipAll() {
    for (const Edge& edge : surface_.edges())
      surface_.flip(edge);
  }

  template <class Body>
  void forEachVertex(const Body& body) const {
    parallelRanges(surface_.vertexCount(), kRemeshedAtOnce, threads_,
                   [&](Eigen::Index begin, Eigen::Index end) {
                     for (auto v = static_cast<Index>(begin); v < static_cast<Index>(end); ++v)
                       if (surface_.exists(v))
                         body(v);
                   });
  }

  void relax(double share, Onto onto) {
    std::vector<Vec3> moved(at(surface_.vertexCount()));
    forEachVertex([&](Index v) { moved[at(v)] = relaxed(v, share, onto); });
    for (Index v = 0; v < surface_.vertexCount(); ++v)
      if (surface_.exists(v))
        surface_.movePoint(v, moved[at(v)]);
  }

  /// p + share (I - n n^T) (g - p), then along n towards the surface where `onto` asks for it: g is the mean
  /// of the centroids of the triangles around the vertex, weighted by A / h^2 so that triangles of any scale
  /// count alike, and n the sum of their area vectors, normalised.
  Vec3 relaxed(Index v, double share, Onto onto) const {
    Vec3 center = Vec3::Zero(), normal = Vec3::Zero();
    double weights = 0, area = 0;
    for (const Index t : surface_.trianglesAround(v)) {
      const auto& [a, b, c] = surface_.corners(t);
      const Vec3 doubleArea = surface_.doubleArea(t);
      const double scale = (scale_[at(a)] + scale_[at(b)] + scale_[at(c)]) / 3;
      const double weight = doubleArea.norm() / (scale * scale);
      center += weight / 3 * (surface_.point(a) + surface_.point(b) + surface_.point(c));
      normal += doubleArea;
      weights += weight;
      area += doubleArea.norm();
    }
    if (weights <= 0 || normal.isZero())
      return surface_.point(v);
    normal.normalize();
    const Vec3 pull = center / weights - surface_.point(v);
    const Vec3 point = surface_.point(v) + share * (pull - pull.dot(normal) * normal);
    const double edge = 0.5 * std::sqrt(area / static_cast<double>(surface_.trianglesAround(v).size()));
    return point + step(point, normal, edge, onto) * normal;
  }

  /// How far to go along the normal, at most `longest` mm.
  double step(const Vec3& point, const Vec3& normal, double longest, Onto onto) const {
    if (onto == Onto::nothing)
      return 0;
    const double limit = 2 * longest;
    const double distance = node_.distanceUpTo(point, limit);
    if (onto == Onto::nearSurface)
      return std::clamp(-0.95 * distance, -longest, longest);
    // Newton along the normal, -d / (dd/dn) with a difference for the slope; in the middle of a thin wall
    // there is no slope, but the distance itself is free.
    const double slope = (node_.distanceUpTo(point + kSlopeProbe * normal, limit) - distance) / kSlopeProbe;
    const double go = slope > kLeastSlope ? -distance / slope : -distance;
    return std::clamp(go, -longest, longest);
  }

  EditableSurface surface_;
  const ImplicitNode& node_;
  Threads threads_;
  std::vector<double> scale_; ///< Wanted edge length at each vertex, relative.
  bool uniform_ = false;
};

} // namespace

TriangleMesh remesh(const TriangleMesh& mesh, const ImplicitNode& node, int triangles, Threads threads,
                    Progress& progress) {
  return Remesher(mesh, node, threads).run(triangles, progress);
}

} // namespace viscera::sample_organs
