#include "viscera/presentation/contour_bend.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "viscera/core/error.h"

namespace viscera::presentation {
namespace {

constexpr double kLeastShare = 0.05;
constexpr double kSamePlaceMm = 0.01;

/// A place on a line of a cut.
struct PlaceOnCut {
  std::size_t line = 0;
  Eigen::Index after = 0; ///< The point of the line before it, counted from the line's first.
  Vec3 point = Vec3::Zero();
};

Eigen::Index endOf(const geometry::PlaneCut& cut, std::size_t line) {
  return line + 1 < cut.lines() ? cut.first[line + 1] : cut.points.rows();
}

PlaceOnCut nearestOn(const geometry::PlaneCut& cut, const Vec3& place) {
  PlaceOnCut nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t line = 0; line < cut.lines(); ++line) {
    const Eigen::Index first = cut.first[line], end = endOf(cut, line);
    for (Eigen::Index row = first; row < end; ++row) {
      const Eigen::Index next = row + 1 < end ? row + 1 : cut.closed[line] ? first : row;
      const Vec3 a = cut.points.row(row), along = cut.points.row(next).transpose() - a;
      const double part = std::clamp((place - a).dot(along) / std::max(along.squaredNorm(), 1e-12), 0.0, 1.0);
      const Vec3 point = a + part * along;
      if (const double apart = (place - point).norm(); apart < least) {
        least = apart;
        nearest = {line, row - first, point};
      }
    }
  }
  return nearest;
}

/// The line with the place as a point of it, and which one that is.
Eigen::Index insert(const PlaceOnCut& place, Points& line) {
  const Eigen::Index next = place.after + 1;
  for (const Eigen::Index row : {place.after, next % line.rows()})
    if ((line.row(row).transpose() - place.point).norm() < kSamePlaceMm)
      return row;
  Points longer(line.rows() + 1, 3);
  longer.topRows(next) = line.topRows(next);
  longer.row(next) = place.point.transpose();
  longer.bottomRows(line.rows() - next) = line.bottomRows(line.rows() - next);
  line = std::move(longer);
  return next;
}

/// Distances along a line from one of its points, the shorter way round where it is closed.
Values alongFrom(const Points& line, Eigen::Index from, bool closed) {
  const Eigen::Index count = line.rows();
  Values since = Values::Zero(count);
  for (Eigen::Index i = 1; i < count; ++i)
    since[i] = since[i - 1] + (line.row(i) - line.row(i - 1)).norm();
  const double whole = since[count - 1] + (closed ? (line.row(0) - line.row(count - 1)).norm() : 0);
  Values apart = (since.array() - since[from]).abs();
  if (closed)
    apart = apart.cwiseMin((whole - apart.array()).matrix());
  return apart;
}

} // namespace

ContourBend::ContourBend(const geometry::PlaneCut& cut, const Vec3& place, double radiusMm) {
  if (cut.lines() == 0 || cut.points.rows() == 0 || !(radiusMm > 0))
    throw UsageError(misuse("There is no contour to bend"));
  const PlaceOnCut nearest = nearestOn(cut, place);
  const Eigen::Index first = cut.first[nearest.line];
  line_ = cut.points.middleRows(first, endOf(cut, nearest.line) - first);
  closed_ = cut.closed[nearest.line];
  const Eigen::Index grabbed = insert(nearest, line_);
  grabbed_ = line_.row(grabbed);
  const Values apart = alongFrom(line_, grabbed, closed_);
  shares_ = (-2 * (apart.array() / radiusMm).square()).exp();
  bent_ = line_;
}

void ContourBend::dragTo(const Vec3& place) {
  by_ = place - grabbed_;
  bent_ = line_ + shares_ * by_.transpose();
}

Points ContourBend::among(const Points& line) const {
  std::vector<Eigen::Index> moved;
  for (Eigen::Index i = 0; i < shares_.size(); ++i)
    if (shares_[i] >= kLeastShare)
      moved.push_back(i);
  return line(moved, Eigen::all);
}

} // namespace viscera::presentation
