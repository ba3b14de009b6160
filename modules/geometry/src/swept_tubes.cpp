#include "viscera/geometry/swept_tubes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::geometry {
namespace {

constexpr int kSides = SweptTubes::kSides;
constexpr double kBlunt = 0.5; ///< How far an end's middle is beyond its rim, of the radius.
constexpr double kNoLength = 1e-9;

/// The direction of a line at one of its points; the one before where the points coincide.
Vec3 directionAt(const Points& points, Eigen::Index first, Eigen::Index last, Eigen::Index i,
                 const Vec3& before) {
  const Vec3 along = points.row(std::min(i + 1, last)) - points.row(std::max(i - 1, first));
  return along.norm() > kNoLength ? Vec3(along.normalized()) : before;
}

/// A unit vector across `along`, as near to `before` as it can be.
Vec3 acrossOf(const Vec3& along, const Vec3& before) {
  const Vec3 across = before - before.dot(along) * along;
  return across.norm() > kNoLength ? Vec3(across.normalized()) : Vec3(along.unitOrthogonal());
}

/// Rings from the first to the last, then the middles of both ends.
Triangles trianglesOf(const std::vector<Eigen::Index>& lines) {
  std::vector<std::array<Eigen::Index, 3>> all;
  Eigen::Index base = 0;
  for (const Eigen::Index rings : lines) {
    const Eigen::Index begin = base + rings * kSides, end = begin + 1;
    for (int side = 0; side < kSides; ++side) {
      const int next = (side + 1) % kSides;
      for (Eigen::Index ring = 0; ring + 1 < rings; ++ring) {
        const Eigen::Index a = base + ring * kSides, b = a + kSides;
        all.push_back({a + side, a + next, b + next});
        all.push_back({a + side, b + next, b + side});
      }
      const Eigen::Index last = begin - kSides;
      all.push_back({begin, base + next, base + side});
      all.push_back({end, last + side, last + next});
    }
    base = end + 1;
  }
  Triangles triangles(static_cast<Eigen::Index>(all.size()), 3);
  for (std::size_t t = 0; t < all.size(); ++t)
    for (int k = 0; k < 3; ++k)
      triangles(static_cast<Eigen::Index>(t), k) =
          static_cast<Triangles::Scalar>(all[t][static_cast<std::size_t>(k)]);
  return triangles;
}

} // namespace

SweptTubes::SweptTubes(std::vector<Eigen::Index> lines, Values radii)
    : lines_(std::move(lines)), radii_(std::move(radii)) {
  const bool lineTooShort = std::any_of(lines_.begin(), lines_.end(), [](auto count) { return count < 2; });
  if (lineTooShort || std::accumulate(lines_.begin(), lines_.end(), Eigen::Index{0}) != radii_.size())
    throw UsageError(misuse("each tube needs two points at least, and each point a radius"));
  triangles_ = trianglesOf(lines_);
  points_ = radii_.size() * kSides + 2 * static_cast<Eigen::Index>(lines_.size());
}

void SweptTubes::at(const Points& lines, Points& out) const {
  if (lines.rows() != radii_.size())
    throw UsageError(misuse("the tubes have another number of points"));
  out.resize(points_, 3);
  Eigen::Index row = 0, first = 0;
  for (const Eigen::Index count : lines_) {
    const Eigen::Index last = first + count - 1;
    Vec3 along = Vec3::UnitZ(), across = Vec3::UnitX(), start = along;
    for (Eigen::Index i = first; i <= last; ++i) {
      along = directionAt(lines, first, last, i, along);
      across = acrossOf(along, i == first ? Vec3(along.unitOrthogonal()) : across);
      if (i == first)
        start = along;
      const Vec3 other = along.cross(across), middle = lines.row(i);
      for (int side = 0; side < kSides; ++side) {
        const double angle = 2 * std::numbers::pi * side / kSides;
        out.row(row++) = middle + radii_[i] * (std::cos(angle) * across + std::sin(angle) * other);
      }
    }
    out.row(row++) = lines.row(first) - kBlunt * radii_[first] * start.transpose();
    out.row(row++) = lines.row(last) + kBlunt * radii_[last] * along.transpose();
    first = last + 1;
  }
}

} // namespace viscera::geometry
