#include "viscera/geometry/surface_gap.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "closest_point.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::geometry {
namespace {

constexpr std::int32_t kTrianglesInALeaf = 4;

using CornerPoints = std::array<Vec3, 3>;

/// Two places and the square of their distance.
struct Way {
  double square = std::numeric_limits<double>::infinity();
  Vec3 from = Vec3::Zero();
  Vec3 to = Vec3::Zero();

  void take(const Vec3& a, const Vec3& b) {
    const double other = (b - a).squaredNorm();
    if (other < square)
      *this = {other, a, b};
  }
};

/// The shortest way between the segments p q and a b. Its ends are an end of one segment and the foot of its
/// perpendicular on the other, unless both lie inside.
void takeSegments(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, Way& way) {
  const Vec3 u = q - p, v = b - a, w = p - a;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v);
  const double determinant = uu * vv - uv * uv;
  if (determinant > 0) {
    // The way is perpendicular to both: (w + s u - t v) . u = 0 and (w + s u - t v) . v = 0.
    const double s = (uv * v.dot(w) - vv * u.dot(w)) / determinant;
    const double t = (uu * v.dot(w) - uv * u.dot(w)) / determinant;
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1)
      way.take(p + s * u, a + t * v);
  }
  way.take(p, closestPointOfSegment(p, a, b));
  way.take(q, closestPointOfSegment(q, a, b));
  way.take(closestPointOfSegment(a, p, q), a);
  way.take(closestPointOfSegment(b, p, q), b);
}

/// Where the segment p q goes through a triangle, if it does.
std::optional<Vec3> piercing(const Vec3& p, const Vec3& q, const CornerPoints& t) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double atP = normal.dot(p - t[0]), atQ = normal.dot(q - t[0]);
  if (!(atP * atQ < 0))
    return std::nullopt;
  const Vec3 place = p + atP / (atP - atQ) * (q - p);
  for (int k = 0; k < 3; ++k)
    if (normal.dot((t[(k + 1) % 3] - t[k]).cross(place - t[k])) < 0)
      return std::nullopt;
  return place;
}

Way wayBetween(const CornerPoints& a, const CornerPoints& b) {
  Way way;
  for (int i = 0; i < 3; ++i) {
    for (const auto& place : {piercing(a[i], a[(i + 1) % 3], b), piercing(b[i], b[(i + 1) % 3], a)})
      if (place)
        return {0, *place, *place};
    way.take(a[i], closestPointOfTriangle(a[i], b[0], b[1], b[2]));
    way.take(closestPointOfTriangle(b[i], a[0], a[1], a[2]), b[i]);
    for (int j = 0; j < 3; ++j)
      takeSegments(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3], way);
  }
  return way;
}

} // namespace

SurfaceBoxes::SurfaceBoxes(Points points, Triangles triangles)
    : points_(std::move(points)), triangles_(std::move(triangles)),
      order_(static_cast<std::size_t>(triangles_.rows())) {
  Points middles(triangles_.rows(), 3);
  for (Eigen::Index t = 0; t < triangles_.rows(); ++t)
    middles.row(t) =
        (points_.row(triangles_(t, 0)) + points_.row(triangles_(t, 1)) + points_.row(triangles_(t, 2))) / 3;
  std::iota(order_.begin(), order_.end(), 0);
  if (!order_.empty())
    grow(middles, 0, static_cast<std::int32_t>(order_.size()));
  fit();
}

/// Halves the triangles at the median across the longest side of the box around their middles.
std::int32_t SurfaceBoxes::grow(const Points& middles, std::int32_t begin, std::int32_t end) {
  const auto index = static_cast<std::int32_t>(branches_.size());
  branches_.push_back({Vec3::Zero(), Vec3::Zero(), begin, end, 0});
  if (end - begin <= kTrianglesInALeaf)
    return index;
  Vec3 low = middles.row(order_[static_cast<std::size_t>(begin)]).transpose(), high = low;
  for (std::int32_t i = begin; i < end; ++i) {
    const Vec3 middle = middles.row(order_[static_cast<std::size_t>(i)]).transpose();
    low = low.cwiseMin(middle);
    high = high.cwiseMax(middle);
  }
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  const std::int32_t half = begin + (end - begin) / 2;
  const auto first = order_.begin();
  std::nth_element(first + begin, first + half, first + end, [&](std::int32_t a, std::int32_t b) {
    return std::pair(middles(a, axis), a) < std::pair(middles(b, axis), b);
  });
  grow(middles, begin, half);
  const std::int32_t second = grow(middles, half, end);
  branches_[static_cast<std::size_t>(index)].second = second;
  return index;
}

/// Children before their parents.
void SurfaceBoxes::fit() {
  for (std::size_t i = branches_.size(); i-- > 0;) {
    Branch& branch = branches_[i];
    if (branch.second != 0) {
      const Branch& first = branches_[i + 1];
      const Branch& second = branches_[static_cast<std::size_t>(branch.second)];
      branch.low = first.low.cwiseMin(second.low);
      branch.high = first.high.cwiseMax(second.high);
      continue;
    }
    branch.low = Vec3::Constant(std::numeric_limits<double>::infinity());
    branch.high = -branch.low;
    for (std::int32_t k = branch.begin; k < branch.end; ++k)
      for (const Vec3& corner : cornersOf(points_, triangles_, order_[static_cast<std::size_t>(k)])) {
        branch.low = branch.low.cwiseMin(corner);
        branch.high = branch.high.cwiseMax(corner);
      }
  }
}

void SurfaceBoxes::follow(const Points& points) {
  assert(points.rows() == points_.rows());
  points_ = points;
  fit();
}

/// Goes down two trees at once, the nearer pair of branches first, and leaves out pairs that are farther from
/// each other than the best way so far.
class GapSearch {
public:
  GapSearch(const SurfaceBoxes& first, const SurfaceBoxes& second) : first_(first), second_(second) {}

  void tryPair(int triangleFrom, int triangleTo) {
    const Way way = wayBetween(cornersOf(first_.points_, first_.triangles_, triangleFrom),
                               cornersOf(second_.points_, second_.triangles_, triangleTo));
    if (way.square >= best_.square)
      return;
    best_ = way;
    gap_.triangleFrom = triangleFrom;
    gap_.triangleTo = triangleTo;
  }

  bool has(const SurfaceGap& gap) const {
    return gap.triangleFrom >= 0 && gap.triangleFrom < first_.triangles_.rows() && gap.triangleTo >= 0 &&
           gap.triangleTo < second_.triangles_.rows();
  }

  SurfaceGap run() {
    visit(0, 0);
    gap_.mm = std::sqrt(best_.square);
    gap_.from = best_.from;
    gap_.to = best_.to;
    return gap_;
  }

private:
  using Branch = SurfaceBoxes::Branch;

  const Branch& of(const SurfaceBoxes& boxes, std::int32_t index) const {
    return boxes.branches_[static_cast<std::size_t>(index)];
  }

  double square(std::int32_t a, std::int32_t b) const {
    const Branch& one = of(first_, a);
    const Branch& other = of(second_, b);
    return (one.low - other.high).cwiseMax(other.low - one.high).cwiseMax(0.0).squaredNorm();
  }

  void visit(std::int32_t a, std::int32_t b) {
    const Branch& one = of(first_, a);
    const Branch& other = of(second_, b);
    if (one.second == 0 && other.second == 0)
      return tryLeaves(one, other);
    // The larger of the two is divided.
    const bool divideFirst =
        other.second == 0 ||
        (one.second != 0 && (one.high - one.low).squaredNorm() >= (other.high - other.low).squaredNorm());
    std::array<std::pair<std::int32_t, std::int32_t>, 2> pairs =
        divideFirst ? std::array{std::pair(a + 1, b), std::pair(one.second, b)}
                    : std::array{std::pair(a, b + 1), std::pair(a, other.second)};
    std::array<double, 2> away = {square(pairs[0].first, pairs[0].second),
                                  square(pairs[1].first, pairs[1].second)};
    if (away[1] < away[0]) {
      std::swap(pairs[0], pairs[1]);
      std::swap(away[0], away[1]);
    }
    for (std::size_t i = 0; i < 2; ++i)
      if (away[i] < best_.square)
        visit(pairs[i].first, pairs[i].second);
  }

  void tryLeaves(const Branch& one, const Branch& other) {
    for (std::int32_t i = one.begin; i < one.end; ++i)
      for (std::int32_t j = other.begin; j < other.end; ++j)
        if (best_.square > 0)
          tryPair(first_.order_[static_cast<std::size_t>(i)], second_.order_[static_cast<std::size_t>(j)]);
  }

  const SurfaceBoxes& first_;
  const SurfaceBoxes& second_;
  Way best_;
  SurfaceGap gap_;
};

SurfaceGap gapBetween(const SurfaceBoxes& first, const SurfaceBoxes& second,
                      const std::optional<SurfaceGap>& before) {
  if (first.empty() || second.empty())
    throw UsageError(misuse("A surface without triangles has no distance from another"));
  GapSearch search(first, second);
  if (before && search.has(*before))
    search.tryPair(before->triangleFrom, before->triangleTo);
  return search.run();
}

} // namespace viscera::geometry
