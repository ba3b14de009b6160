#include "viscera/geometry/plane_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::geometry {
namespace {

using Index = Eigen::Index;

constexpr std::size_t kMostPlanes = 8;
constexpr Index kPointGrain = 16384;
constexpr Index kTriangleGrain = 32768;

/// Bit k is set where the point lies in or above plane k.
using Sides = std::vector<std::uint8_t>;

/// A part of one surface's points or triangles: what one thread takes at a time.
struct Piece {
  std::size_t surface = 0;
  Index begin = 0, end = 0;
};

template <class Count>
std::vector<Piece> piecesOf(const std::vector<SurfaceView>& surfaces, Index grain, Count count) {
  std::vector<Piece> pieces;
  for (std::size_t s = 0; s < surfaces.size(); ++s)
    for (Index begin = 0, all = count(s); begin < all; begin += grain)
      pieces.push_back({s, begin, std::min(all, begin + grain)});
  return pieces;
}

/// Calls `work` with the number of each item, one after the other on each thread.
template <class Work>
void forEach(std::size_t count, Threads threads, Work work) {
  parallelRanges(static_cast<Index>(count), 1, threads, [&](Index begin, Index end) {
    for (Index i = begin; i < end; ++i)
      work(static_cast<std::size_t>(i));
  });
}

/// The sides that the points of a piece lie on; the bits that all of them have, and those that any has.
std::array<std::uint8_t, 2> sidesOf(const Points& points, const Piece& piece,
                                    const std::vector<Plane>& planes, Sides& sides) {
  std::array<std::uint8_t, 2> allAndAny = {0xff, 0};
  std::array<Vec3, kMostPlanes> normals;
  std::array<double, kMostPlanes> offsets{};
  for (std::size_t k = 0; k < planes.size(); ++k) {
    normals[k] = planes[k].normal;
    offsets[k] = planes[k].normal.dot(planes[k].origin);
  }
  const double* p = points.data() + 3 * piece.begin;
  for (Index i = piece.begin; i < piece.end; ++i, p += 3) {
    unsigned bits = 0;
    for (std::size_t k = 0; k < planes.size(); ++k) {
      const Vec3& n = normals[k];
      bits |= static_cast<unsigned>(n[0] * p[0] + n[1] * p[1] + n[2] * p[2] >= offsets[k]) << k;
    }
    sides[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(bits);
    allAndAny[0] &= static_cast<std::uint8_t>(bits);
    allAndAny[1] |= static_cast<std::uint8_t>(bits);
  }
  return allAndAny;
}

/// The triangles of a piece that some plane cuts, ascending.
std::vector<std::int32_t> crossedOf(const Triangles& triangles, const Piece& piece, const Sides& sides) {
  std::vector<std::int32_t> crossed;
  const std::int32_t* t = triangles.data() + 3 * piece.begin;
  for (Index i = piece.begin; i < piece.end; ++i, t += 3) {
    const std::uint8_t a = sides[static_cast<std::size_t>(t[0])];
    const std::uint8_t b = sides[static_cast<std::size_t>(t[1])];
    const std::uint8_t c = sides[static_cast<std::size_t>(t[2])];
    if ((a ^ b) | (a ^ c))
      crossed.push_back(static_cast<std::int32_t>(i));
  }
  return crossed;
}

/// An edge of the surface by its vertices, the lower one in the upper half.
using EdgeKey = std::uint64_t;

EdgeKey edgeOf(std::int32_t a, std::int32_t b) {
  const auto [low, high] = std::minmax(a, b);
  return static_cast<EdgeKey>(static_cast<std::uint32_t>(low)) << 32 | static_cast<std::uint32_t>(high);
}

/// The piece of a line in one triangle.
struct Segment {
  EdgeKey from = 0, to = 0;
};

/// Joins segments end to end, and finds where each edge meets the plane. One surface, one plane.
class Joiner {
public:
  Joiner(const Points& points, const Plane& plane, std::vector<Segment> segments)
      : points_(points), plane_(plane), segments_(std::move(segments)) {
    std::sort(segments_.begin(), segments_.end(), [](const Segment& a, const Segment& b) {
      return std::pair(a.from, a.to) < std::pair(b.from, b.to);
    });
    used_.resize(segments_.size());
  }

  PlaneCut cut() {
    result_.first.push_back(0);
    // Open lines from where they begin; then what is left are rings.
    std::vector<EdgeKey> ends;
    ends.reserve(segments_.size());
    for (const Segment& segment : segments_)
      ends.push_back(segment.to);
    std::sort(ends.begin(), ends.end());
    for (std::size_t i = 0; i < segments_.size(); ++i)
      if (!used_[i] && !std::binary_search(ends.begin(), ends.end(), segments_[i].from))
        follow(i);
    for (std::size_t i = 0; i < segments_.size(); ++i)
      if (!used_[i])
        follow(i);
    result_.points.resize(static_cast<Index>(places_.size()), 3);
    for (std::size_t i = 0; i < places_.size(); ++i)
      result_.points.row(static_cast<Index>(i)) = places_[i].transpose();
    return std::move(result_);
  }

private:
  void follow(std::size_t start) {
    const EdgeKey begin = segments_[start].from;
    const std::size_t firstPlace = places_.size();
    places_.push_back(placeOf(begin));
    bool ring = false;
    for (std::size_t at = start; at < segments_.size();) {
      used_[at] = true;
      const EdgeKey end = segments_[at].to;
      ring = end == begin;
      if (ring)
        break;
      addPlace(placeOf(end), firstPlace);
      at = nextFrom(end);
    }
    if (ring)
      result_.lengthMm += (places_[firstPlace] - places_.back()).norm();
    result_.closed.push_back(ring);
    result_.first.push_back(static_cast<std::int32_t>(places_.size()));
  }

  void addPlace(const Vec3& place, std::size_t firstPlace) {
    if (places_.size() > firstPlace)
      result_.lengthMm += (place - places_.back()).norm();
    places_.push_back(place);
  }

  /// The first segment from that edge that is in no line yet; behind the last when there is none.
  std::size_t nextFrom(EdgeKey edge) const {
    auto found = std::lower_bound(segments_.begin(), segments_.end(), edge,
                                  [](const Segment& segment, EdgeKey key) { return segment.from < key; });
    for (; found != segments_.end() && found->from == edge; ++found)
      if (const auto i = static_cast<std::size_t>(found - segments_.begin()); !used_[i])
        return i;
    return segments_.size();
  }

  /// Always from the lower vertex, so that both triangles of an edge have the same point.
  Vec3 placeOf(EdgeKey edge) const {
    const Vec3 a = points_.row(static_cast<Index>(edge >> 32)).transpose();
    const Vec3 b = points_.row(static_cast<Index>(edge & 0xffffffffu)).transpose();
    const double below = plane_.height(a), above = plane_.height(b);
    // h_a + t (h_b - h_a) = 0 at t = h_a / (h_a - h_b).
    const double part = below == above ? 0.5 : std::clamp(below / (below - above), 0.0, 1.0);
    return a + part * (b - a);
  }

  const Points& points_;
  const Plane& plane_;
  std::vector<Segment> segments_; ///< By the edge that they begin at.
  std::vector<bool> used_;
  std::vector<Vec3> places_;
  PlaneCut result_;
};

/// The segments in which plane `k` cuts the crossed triangles, from the edge where the triangle's outline
/// goes down to where it comes up again.
std::vector<Segment> segmentsOf(const Triangles& triangles, const std::vector<std::int32_t>& crossed,
                                const Sides& sides, std::size_t k) {
  std::vector<Segment> segments;
  for (const std::int32_t t : crossed) {
    const auto corner = [&](int i) { return triangles(t, i % 3); };
    const auto above = [&](int i) { return (sides[static_cast<std::size_t>(corner(i))] >> k & 1) != 0; };
    Segment segment;
    int ends = 0;
    for (int i = 0; i < 3; ++i) {
      if (above(i) == above(i + 1))
        continue;
      (above(i) ? segment.from : segment.to) = edgeOf(corner(i), corner(i + 1));
      ++ends;
    }
    if (ends == 2)
      segments.push_back(segment);
  }
  return segments;
}

} // namespace

std::vector<std::vector<PlaneCut>> cutSurfaces(const std::vector<SurfaceView>& surfaces,
                                               const std::vector<Plane>& planes, Threads threads) {
  if (planes.size() > kMostPlanes)
    throw UsageError(misuse("Surfaces are cut by at most 8 planes at once, not by %1", planes.size()));
  std::vector<Sides> sides(surfaces.size());
  for (std::size_t s = 0; s < surfaces.size(); ++s)
    sides[s].resize(static_cast<std::size_t>(surfaces[s].points->rows()));
  const auto ofPoints =
      piecesOf(surfaces, kPointGrain, [&](std::size_t s) { return surfaces[s].points->rows(); });
  std::vector<std::array<std::uint8_t, 2>> bits(ofPoints.size());
  forEach(ofPoints.size(), threads, [&](std::size_t i) {
    const Piece& piece = ofPoints[i];
    bits[i] = sidesOf(*surfaces[piece.surface].points, piece, planes, sides[piece.surface]);
  });
  std::vector<std::array<std::uint8_t, 2>> ofSurface(surfaces.size(), {0xff, 0});
  for (std::size_t i = 0; i < ofPoints.size(); ++i) {
    ofSurface[ofPoints[i].surface][0] &= bits[i][0];
    ofSurface[ofPoints[i].surface][1] |= bits[i][1];
  }
  const auto met = [&](std::size_t s) { return ofSurface[s][0] != ofSurface[s][1]; };
  const auto ofTriangles = piecesOf(surfaces, kTriangleGrain, [&](std::size_t s) {
    return met(s) ? surfaces[s].triangles->rows() : Index(0);
  });
  std::vector<std::vector<std::int32_t>> found(ofTriangles.size());
  forEach(ofTriangles.size(), threads, [&](std::size_t i) {
    const Piece& piece = ofTriangles[i];
    found[i] = crossedOf(*surfaces[piece.surface].triangles, piece, sides[piece.surface]);
  });
  std::vector<std::vector<std::int32_t>> crossed(surfaces.size());
  for (std::size_t i = 0; i < ofTriangles.size(); ++i) {
    auto& list = crossed[ofTriangles[i].surface];
    list.insert(list.end(), found[i].begin(), found[i].end());
  }
  std::vector<std::vector<PlaneCut>> cuts(surfaces.size(), std::vector<PlaneCut>(planes.size()));
  forEach(surfaces.size() * planes.size(), threads, [&](std::size_t i) {
    const std::size_t s = i / planes.size(), k = i % planes.size();
    cuts[s][k] =
        Joiner(*surfaces[s].points, planes[k], segmentsOf(*surfaces[s].triangles, crossed[s], sides[s], k))
            .cut();
  });
  return cuts;
}

PlaneCut cutSurface(const SurfaceView& surface, const Plane& plane, Threads threads) {
  return std::move(cutSurfaces({surface}, {plane}, threads).front().front());
}

bool isInside(const PlaneCut& cut, const Plane& plane, const Vec3& point) {
  Eigen::Index away = 0; // The axis that the normal is farthest from gives directions in the plane.
  plane.normal.cwiseAbs().minCoeff(&away);
  const Vec3 across = plane.normal.cross(Vec3::Unit(away)).normalized();
  const Vec3 along = plane.normal.cross(across);
  bool inside = false;
  for (std::size_t line = 0; line < cut.lines(); ++line) {
    if (!cut.closed[line])
      continue;
    const Index begin = cut.first[line], end = cut.first[line + 1];
    Vec3 before = cut.points.row(end - 1).transpose() - point;
    for (Index i = begin; i < end; ++i) {
      const Vec3 now = cut.points.row(i).transpose() - point;
      const double y0 = along.dot(before), y1 = along.dot(now);
      if ((y0 > 0) != (y1 > 0)) {
        const double x0 = across.dot(before), x1 = across.dot(now);
        // Where the line crosses y = 0, at x_0 + (x_1 - x_0) y_0 / (y_0 - y_1), to the right of the point: an
        // odd number of times from inside.
        inside ^= x0 + (x1 - x0) * y0 / (y0 - y1) > 0;
      }
      before = now;
    }
  }
  return inside;
}

} // namespace viscera::geometry
