#include "viscera/strain/heart_axes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/strain/valve_caps.h"

namespace viscera::strain {
namespace {

using std::numbers::pi;

/// Shorter long axes are no ventricle's, mm; nearer to the axis a direction across it is not known.
constexpr double kShortestAxisMm = 1e-6;
/// Part of the long axis in which insertions are looked for: below the outflow, above the apex.
constexpr double kInsertionsFrom = 0.25, kInsertionsTo = 0.65;
constexpr int kInsertionLevels = 5;
/// Part of the vertices beyond each insertion, which are taken for trabeculae.
constexpr double kBeyond = 0.02;
constexpr std::size_t kFewestAtLevel = 12;
/// Between both insertions; other spans are not a septum's, and the angle of a usual one is taken.
constexpr double kNarrowest = 40 * pi / 180, kWidest = 220 * pi / 180, kUsual = 120 * pi / 180;

Vec3 farthestFrom(const Vec3& from, const Points& points) {
  Eigen::Index row = 0;
  (points.rowwise() - from.transpose()).rowwise().squaredNorm().maxCoeff(&row);
  return points.row(row).transpose();
}

Vec3 anyAcross(const Vec3& direction) {
  return direction.unitOrthogonal();
}

/// Both ends of the right ventricle as seen from the axis.
struct Insertions {
  double anterior = 0; ///< Angle in the axes given, rad.
  double span = 0;     ///< Up to the inferior one; 0 where the middle is all that is known.
};

double quantile(std::vector<double> values, double part) {
  const auto place = static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

/// `axes` are along the long axis and turned anyhow.
Insertions insertionsOf(const HeartAxes& axes, const Points& right) {
  Vec3 middle = Vec3::Zero();
  for (const auto& row : right.rowwise()) {
    const Vec3 from = row.transpose() - axes.base();
    middle += from - from.dot(axes.down()) * axes.down();
  }
  const double center = axes.angleOf(axes.base() + middle);
  std::vector<std::vector<double>> levels(kInsertionLevels);
  for (const auto& row : right.rowwise()) {
    const double height =
        (axes.heightOf(row.transpose()) - kInsertionsFrom) / (kInsertionsTo - kInsertionsFrom);
    if (height >= 0 && height < 1)
      levels[static_cast<std::size_t>(height * kInsertionLevels)].push_back(
          std::remainder(axes.angleOf(row.transpose()) - center, 2 * pi));
  }
  std::vector<double> first, last;
  for (const std::vector<double>& level : levels)
    if (level.size() >= kFewestAtLevel) {
      first.push_back(quantile(level, kBeyond));
      last.push_back(quantile(level, 1 - kBeyond));
    }
  if (first.empty())
    return {center - kUsual / 2, 0};
  const double from = quantile(first, 0.5), span = quantile(last, 0.5) - from;
  if (span < kNarrowest || span > kWidest)
    return {center + from + span / 2 - kUsual / 2, 0};
  return {center + from, span};
}

} // namespace

HeartAxes::HeartAxes(const Vec3& base, const Vec3& apex, const Vec3& towardsInsertion)
    : base_(base), apex_(apex), length_((apex - base).norm()) {
  if (!(length_ > kShortestAxisMm))
    throw DataError("The base and the apex are the same place", "heart", "choose two other points");
  down_ = (apex - base) / length_;
  first_ = towardsInsertion - towardsInsertion.dot(down_) * down_;
  if (!(first_.norm() > kShortestAxisMm * std::max(1.0, towardsInsertion.norm())))
    throw DataError("The insertion of the right ventricle lies on the long axis", "heart",
                    "choose a point of the wall");
  first_.normalize();
  // Seen from the apex the segments run anticlockwise: from the front through the septum to the inferior
  // wall.
  second_ = down_.cross(first_);
}

Vec3 HeartAxes::across(double angle) const {
  return std::cos(angle) * first_ + std::sin(angle) * second_;
}

double HeartAxes::angleOf(const Vec3& point) const {
  const Vec3 from = point - base_;
  const double angle = std::atan2(from.dot(second_), from.dot(first_));
  return angle < 0 ? angle + 2 * pi : angle;
}

double HeartAxes::distanceOf(const Vec3& point) const {
  const Vec3 from = point - base_;
  return (from - from.dot(down_) * down_).norm();
}

FoundAxes findAxes(const geometry::TriangleMesh& leftCavity, const geometry::TriangleMesh* rightCavity,
                   const AxisLandmarks& given) {
  geometry::requireValid(leftCavity, "heart");
  ValveCaps caps = valveCaps(
      leftCavity, given.base && given.apex ? std::optional<Vec3>(*given.base - *given.apex) : std::nullopt);
  const Vec3 base = given.base.value_or(caps.largestMiddle);
  const Vec3 apex = given.apex.value_or(farthestFrom(base, leftCavity.points));
  const bool hasRight = rightCavity && rightCavity->points.rows() > 0;
  if (given.insertion)
    return {HeartAxes(base, apex, *given.insertion - base), std::move(caps.triangles), true, 0};
  const HeartAxes turned(base, apex, anyAcross(apex - base));
  if (!hasRight)
    return {turned, std::move(caps.triangles), false, 0};
  const Insertions found = insertionsOf(turned, rightCavity->points);
  return {HeartAxes(base, apex, turned.across(found.anterior)), std::move(caps.triangles), true,
          found.span * 180 / pi};
}

} // namespace viscera::strain
