#include "polygon_triangles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace viscera::medical_io {
namespace {

using Vec2 = Eigen::Vector2d;
/// Positions in the polygon's list of corners.
using Corners = std::array<std::size_t, 3>;

constexpr std::size_t kMostEarCorners = 5000;
constexpr std::size_t kMostSearchedCorners = 200;

/// Relative to the polygon's size: nearer is on the line, because files state six digits and more.
constexpr double kOnLine = 1e-7;
/// Relative to the polygon's size: corners that are nearer to a plane count as flat.
constexpr double kFlat = 1e-3;
/// The sum of the triangles' areas may exceed the polygon's by this part of it, or of its squared size.
constexpr double kExcessOfArea = 1e-3;
constexpr double kExcessOfSquare = 1e-6;

Vec3 normalOf(const Points& points, std::int32_t a, std::int32_t b, std::int32_t c) {
  const Vec3 pa = points.row(a);
  const Vec3 pb = points.row(b);
  const Vec3 pc = points.row(c);
  return (pb - pa).cross(pc - pa);
}

void cutQuadrilateral(std::span<const std::int32_t> q, const Points& points,
                      std::vector<std::array<std::int32_t, 3>>& out) {
  const bool straight = normalOf(points, q[0], q[1], q[2]).dot(normalOf(points, q[0], q[2], q[3])) > 0;
  const bool crossed = normalOf(points, q[1], q[2], q[3]).dot(normalOf(points, q[1], q[3], q[0])) > 0;
  const double firstDiagonal = (points.row(q[0]) - points.row(q[2])).squaredNorm();
  const double secondDiagonal = (points.row(q[1]) - points.row(q[3])).squaredNorm();
  if (straight != crossed ? straight : firstDiagonal <= secondDiagonal) {
    out.push_back({q[0], q[1], q[2]});
    out.push_back({q[0], q[2], q[3]});
  } else {
    out.push_back({q[1], q[2], q[3]});
    out.push_back({q[1], q[3], q[0]});
  }
}

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// A polygon seen along its normal, counter-clockwise.
struct FlatPolygon {
  std::vector<Vec2> corners;
  double size = 0; ///< Its extent.
  double area = 0; ///< Signed; by its normal at least 0.
  bool flat = true;
  bool straight = false; ///< All corners are in one line.

  double doubleArea(std::size_t a, std::size_t b, std::size_t c) const {
    return cross(corners[b] - corners[a], corners[c] - corners[a]);
  }
};

/// A direction across corners that enclose no area, such as those of an eight; zero where all are in a line.
Vec3 directionAcross(const Points& corners, double size) {
  const auto farthest = [&](const auto& distanceOf) {
    Eigen::Index best = 0;
    for (Eigen::Index i = 1; i < corners.rows(); ++i)
      if (distanceOf(i) > distanceOf(best))
        best = i;
    return best;
  };
  const Vec3 first = corners.row(0);
  const auto offset = [&](Eigen::Index i) { return Vec3(corners.row(i).transpose() - first); };
  const Vec3 along = offset(farthest([&](Eigen::Index i) { return offset(i).norm(); })).normalized();
  const auto across = [&](Eigen::Index i) { return Vec3(along.cross(offset(i))); };
  const Vec3 normal = across(farthest([&](Eigen::Index i) { return across(i).norm(); }));
  return normal.norm() > kOnLine * size ? Vec3(normal.normalized()) : Vec3(Vec3::Zero());
}

FlatPolygon flattened(std::span<const std::int32_t> polygon, const Points& points) {
  const auto count = static_cast<Eigen::Index>(polygon.size());
  Points corners(count, 3);
  for (Eigen::Index i = 0; i < count; ++i)
    corners.row(i) = points.row(polygon[static_cast<std::size_t>(i)]);
  const Vec3 middle = corners.colwise().mean();
  corners.rowwise() -= middle.transpose();

  FlatPolygon result;
  result.size = (corners.colwise().maxCoeff() - corners.colwise().minCoeff()).norm();
  Vec3 normal = Vec3::Zero(); // Newell's: twice the area.
  for (Eigen::Index i = 0; i < count; ++i)
    normal += Vec3(corners.row(i)).cross(Vec3(corners.row((i + 1) % count)));
  const bool encloses = normal.norm() > kOnLine * kOnLine * result.size * result.size;
  normal = encloses ? Vec3(normal.normalized()) : directionAcross(corners, result.size);
  result.straight = normal.isZero();
  if (result.straight)
    return result;
  const Vec3 u = normal.unitOrthogonal();
  const Vec3 v = normal.cross(u);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Vec3 corner = corners.row(i);
    result.corners.emplace_back(corner.dot(u), corner.dot(v));
    result.flat = result.flat && std::abs(corner.dot(normal)) <= kFlat * result.size;
  }
  for (std::size_t i = 0; i < result.corners.size(); ++i)
    result.area += cross(result.corners[i], result.corners[(i + 1) % result.corners.size()]) / 2;
  return result;
}

/// Cuts ear after ear.
class EarCutter {
public:
  explicit EarCutter(const FlatPolygon& polygon)
      : polygon_(polygon), tolerance_(kOnLine * polygon.size), before_(polygon.corners.size()),
        behind_(polygon.corners.size()), quality_(polygon.corners.size()), entered_(polygon.corners.size()) {
    const std::size_t count = before_.size();
    for (std::size_t i = 0; i < count; ++i) {
      before_[i] = (i + count - 1) % count;
      behind_[i] = (i + 1) % count;
    }
    for (std::size_t i = 0; i < count; ++i)
      measure(i);
  }

  /// False when no ear is left before the polygon is cut; then `out` has a part of the triangles.
  bool run(std::vector<Corners>& out) {
    for (std::size_t left = before_.size(); left > 3; --left) {
      const std::size_t ear = nextEar();
      if (ear == kNoEar)
        return false;
      const std::size_t a = before_[ear];
      const std::size_t c = behind_[ear];
      out.push_back({a, ear, c});
      behind_[a] = c;
      before_[c] = a;
      first_ = a;
      measure(a);
      measure(c);
    }
    out.push_back({before_[first_], first_, behind_[first_]});
    return true;
  }

private:
  static constexpr std::size_t kNoEar = std::numeric_limits<std::size_t>::max();

  /// The height over the longest edge relative to that edge; negative for a corner that points inward.
  void measure(std::size_t b) {
    const std::size_t a = before_[b];
    const std::size_t c = behind_[b];
    const auto& p = polygon_.corners;
    const double longest =
        std::max({(p[b] - p[a]).squaredNorm(), (p[c] - p[b]).squaredNorm(), (p[a] - p[c]).squaredNorm()});
    const double doubleArea = polygon_.doubleArea(a, b, c);
    const bool flat = std::abs(doubleArea) <= tolerance_ * std::sqrt(longest);
    quality_[b] = flat ? 0.0 : doubleArea / longest;
    entered_[b] = false;
  }

  std::size_t nextEar() {
    for (int attempt = 0; attempt < 2; ++attempt) {
      for (std::size_t best = bestCorner(); best != kNoEar; best = bestCorner()) {
        if (isFree(best))
          return best;
        entered_[best] = true;
      }
      // Cuts since then may have freed some.
      std::fill(entered_.begin(), entered_.end(), false);
    }
    return kNoEar;
  }

  /// Ears beside corners in a line go first: of three corners in a line left at the end only a triangle
  /// without area could be made.
  double rank(std::size_t b) const {
    const bool besideFlat = quality_[before_[b]] == 0 || quality_[behind_[b]] == 0;
    return quality_[b] > 0 && besideFlat ? 1 + quality_[b] : quality_[b];
  }

  std::size_t bestCorner() const {
    std::size_t best = kNoEar;
    std::size_t at = first_;
    do {
      if (quality_[at] >= 0 && !entered_[at] && (best == kNoEar || rank(at) > rank(best)))
        best = at;
      at = behind_[at];
    } while (at != first_);
    return best;
  }

  /// Whether no edge of the polygon enters the triangle at this corner. The polygon then is on the inner side
  /// of the triangle's two edges, and so everywhere in it. A triangle without area has no inside to enter.
  bool isFree(std::size_t b) const {
    if (quality_[b] == 0)
      return true;
    const std::array<Vec2, 3> triangle = {polygon_.corners[before_[b]], polygon_.corners[b],
                                          polygon_.corners[behind_[b]]};
    std::array<Vec2, 3> inward;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 edge = (triangle[(k + 1) % 3] - triangle[k]).normalized();
      inward[k] = Vec2(-edge.y(), edge.x());
    }
    for (std::size_t at = behind_[b]; at != before_[b]; at = behind_[at])
      if (enters(polygon_.corners[at], polygon_.corners[behind_[at]], triangle, inward))
        return false;
    return true;
  }

  bool enters(const Vec2& from, const Vec2& to, const std::array<Vec2, 3>& triangle,
              const std::array<Vec2, 3>& inward) const {
    double low = 0;
    double high = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const double atFrom = inward[k].dot(from - triangle[k]) - tolerance_;
      const double atTo = inward[k].dot(to - triangle[k]) - tolerance_;
      if (atFrom <= 0 && atTo <= 0)
        return false;
      if (atFrom <= 0)
        low = std::max(low, atFrom / (atFrom - atTo));
      else if (atTo <= 0)
        high = std::min(high, atFrom / (atFrom - atTo));
    }
    return low < high;
  }

  const FlatPolygon& polygon_;
  double tolerance_;
  std::vector<std::size_t> before_;
  std::vector<std::size_t> behind_;
  std::vector<double> quality_;
  std::vector<bool> entered_; ///< Corners that are no ears at the moment.
  std::size_t first_ = 0;     ///< A corner that is left.
};

/// The triangles with the least sum of areas, by dynamic programming over the polygon's chains. O(n^3).
std::vector<Corners> leastTriangles(const FlatPolygon& polygon) {
  const std::size_t count = polygon.corners.size();
  std::vector<double> least(count * count, 0.0);
  std::vector<std::size_t> between(count * count, 0);
  for (std::size_t length = 2; length < count; ++length)
    for (std::size_t i = 0; i + length < count; ++i) {
      const std::size_t j = i + length;
      double& best = least[i * count + j] = std::numeric_limits<double>::infinity();
      for (std::size_t k = i + 1; k < j; ++k) {
        const double sum =
            least[i * count + k] + least[k * count + j] + std::abs(polygon.doubleArea(i, k, j));
        if (sum < best) {
          best = sum;
          between[i * count + j] = k;
        }
      }
    }
  std::vector<Corners> triangles;
  std::vector<std::pair<std::size_t, std::size_t>> open = {{0, count - 1}};
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    if (j - i < 2)
      continue;
    const std::size_t k = between[i * count + j];
    triangles.push_back({i, k, j});
    open.emplace_back(i, k);
    open.emplace_back(k, j);
  }
  return triangles;
}

std::vector<Corners> fanOf(std::size_t count) {
  std::vector<Corners> triangles;
  for (std::size_t k = 1; k + 1 < count; ++k)
    triangles.push_back({0, k, k + 1});
  return triangles;
}

bool covers(const std::vector<Corners>& triangles, const FlatPolygon& polygon) {
  double sum = 0;
  for (const Corners& t : triangles)
    sum += std::abs(polygon.doubleArea(t[0], t[1], t[2])) / 2;
  return sum - polygon.area <=
         std::max(kExcessOfArea * polygon.area, kExcessOfSquare * polygon.size * polygon.size);
}

} // namespace

PolygonCut triangulatePolygon(std::span<const std::int32_t> polygon, const Points& points,
                              std::vector<std::array<std::int32_t, 3>>& out) {
  if (polygon.size() == 3) {
    out.push_back({polygon[0], polygon[1], polygon[2]});
    return PolygonCut::exact;
  }
  if (polygon.size() == 4) {
    cutQuadrilateral(polygon, points, out);
    return PolygonCut::exact;
  }
  const FlatPolygon seen = flattened(polygon, points);
  std::vector<Corners> triangles;
  bool exact = false;
  if (seen.straight) {
    triangles = fanOf(polygon.size());
    exact = true;
  } else if (polygon.size() <= kMostEarCorners) {
    exact = EarCutter(seen).run(triangles) && covers(triangles, seen);
  }
  if (!exact && polygon.size() <= kMostSearchedCorners) {
    triangles = leastTriangles(seen);
    exact = covers(triangles, seen);
  }
  if (triangles.size() + 2 != polygon.size()) {
    triangles = fanOf(polygon.size());
    exact = covers(triangles, seen);
  }
  if (!exact && seen.flat)
    return PolygonCut::failed;
  for (const Corners& t : triangles)
    out.push_back({polygon[t[0]], polygon[t[1]], polygon[t[2]]});
  return exact ? PolygonCut::exact : PolygonCut::uneven;
}

} // namespace viscera::medical_io
