#include "viscera/heart/wall_motion.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "viscera/anatomy/norms.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::heart {
namespace {

using std::numbers::pi;

/// Fewer vertices than these are no region.
constexpr std::size_t kFewestVertices = 6;
/// Along the axis below the mitral valve, mm.
constexpr double kBase[2] = {2, 8};
constexpr double kTurningBase[2] = {4, 14};
constexpr double kTurningApex[2] = {70, 82};
constexpr double kRightBaseSegment[2] = {0, 8};
constexpr double kWall[2] = {15, 50};
constexpr double kSlice = 7;
/// The middle of the right ventricle's free wall at its base, and how far to either side of it, rad.
constexpr double kRightMiddle = 0.436;
constexpr double kRightReach = 0.35;
/// The free wall of the left ventricle to either side of what is opposite to the right one, rad.
constexpr double kFreeReach = 0.9;
/// Nearer to the axis than this part of the widest place is no wall, but the valves' plane.
constexpr double kRim = 0.6;
constexpr double kRightRim = 0.75;
/// Farther from the axis lie vessels, mm.
constexpr double kOutermost = 45;

/// The difference of two angles, -pi to pi.
double angleBetween(double from, double to) {
  return std::remainder(to - from, 2 * pi);
}

bool within(double x, const double (&range)[2]) {
  return x >= range[0] && x <= range[1];
}

void requireEnough(std::size_t count, const char* where) {
  if (count < kFewestVertices)
    throw DataError(phrase("Only %n {vertex|vertices} of the surface {lies|lie} there", count), where,
                    "take a finer surface");
}

} // namespace

WallGauge::WallGauge(const HeartFrame& frame, const HeartSurfaces& rest)
    : frame_(frame), leftCount_(rest.leftCavity.rows()), rightCount_(rest.rightCavity.rows()),
      outerCount_(rest.outer.rows()) {
  const auto chosen = [&frame](const Points& points, const std::function<bool(const HeartPoint&)>& wanted) {
    Region region;
    for (Eigen::Index row = 0; row < points.rows(); ++row)
      if (const HeartPoint place = frame.cylindrical(points.row(row)); wanted(place))
        region.push_back({row, place});
    return region;
  };
  const auto keepRim = [](Region& region, double part) {
    double widest = 0;
    for (const Followed& vertex : region)
      widest = std::max(widest, vertex.rest.rho);
    std::erase_if(region, [&](const Followed& vertex) { return vertex.rest.rho < part * widest; });
  };
  const auto ring = [&](const double(&range)[2]) {
    return chosen(rest.leftCavity, [&range](const HeartPoint& p) { return within(p.c, range); });
  };
  leftBase_ = ring(kBase);
  keepRim(leftBase_, kRim);
  turningBase_ = ring(kTurningBase);
  keepRim(turningBase_, kRim);
  turningApex_ = ring(kTurningApex);
  rightBase_ = chosen(rest.rightCavity, [](const HeartPoint& p) {
    return within(p.c, kRightBaseSegment) && std::abs(angleBetween(kRightMiddle, p.phi)) < kRightReach;
  });
  keepRim(rightBase_, kRightRim);
  requireEnough(leftBase_.size(), "base of the left ventricle");
  requireEnough(turningBase_.size(), "base of the left ventricle");
  requireEnough(turningApex_.size(), "apex of the left ventricle");
  requireEnough(rightBase_.size(), "base of the right ventricle");
  for (double c = kWall[0]; c < kWall[1]; c += kSlice) {
    const auto inSlice = [c](const HeartPoint& p) {
      return p.c >= c && p.c < c + kSlice && std::abs(angleBetween(pi, p.phi)) < kFreeReach &&
             p.rho < kOutermost;
    };
    wall_.push_back({chosen(rest.leftCavity, inSlice), chosen(rest.outer, inSlice)});
    requireEnough(wall_.back().inner.size(), "free wall of the left ventricle, inside");
    requireEnough(wall_.back().outer.size(), "free wall of the left ventricle, outside");
  }
}

double WallGauge::alongOf(const Region& region, const Points& points) const {
  double sum = 0;
  for (const Followed& vertex : region)
    sum += frame_.cylindrical(points.row(vertex.row)).c - vertex.rest.c;
  return sum / static_cast<double>(region.size());
}

double WallGauge::turnOf(const Region& region, const Points& points) const {
  double sum = 0;
  for (const Followed& vertex : region)
    sum += angleBetween(vertex.rest.phi, frame_.cylindrical(points.row(vertex.row)).phi);
  return sum / static_cast<double>(region.size());
}

double WallGauge::rhoOf(const Region& region, const Points& points) const {
  double sum = 0;
  for (const Followed& vertex : region)
    sum += frame_.cylindrical(points.row(vertex.row)).rho;
  return sum / static_cast<double>(region.size());
}

WallPlaces WallGauge::at(const HeartSurfaces& now) const {
  if (now.leftCavity.rows() != leftCount_ || now.rightCavity.rows() != rightCount_ ||
      now.outer.rows() != outerCount_)
    throw DataError(misuse("The surfaces are not those that were measured at rest"), "heart");
  WallPlaces places;
  places.leftBaseMm = alongOf(leftBase_, now.leftCavity);
  places.rightBaseMm = alongOf(rightBase_, now.rightCavity);
  places.baseTurn = turnOf(turningBase_, now.leftCavity);
  places.apexTurn = turnOf(turningApex_, now.leftCavity);
  for (const Slice& slice : wall_)
    places.wallMm += rhoOf(slice.outer, now.outer) - rhoOf(slice.inner, now.leftCavity);
  places.wallMm /= static_cast<double>(wall_.size());
  return places;
}

WallMotion wallMotion(const std::vector<WallPlaces>& beat) {
  const auto span = [&beat](double WallPlaces::*value) {
    const auto [low, high] =
        std::minmax_element(beat.begin(), beat.end(), [value](const WallPlaces& a, const WallPlaces& b) {
          return a.*value < b.*value;
        });
    return std::pair((*low).*value, (*high).*value);
  };
  const auto [leftLow, leftHigh] = span(&WallPlaces::leftBaseMm);
  const auto [rightLow, rightHigh] = span(&WallPlaces::rightBaseMm);
  const auto [thin, thick] = span(&WallPlaces::wallMm);
  WallMotion motion;
  motion.mapseMm = leftHigh - leftLow;
  motion.tapseMm = rightHigh - rightLow;
  for (const WallPlaces& places : beat)
    motion.twistDegrees = std::max(motion.twistDegrees, (places.apexTurn - places.baseTurn) * 180 / pi);
  motion.thinnestWallMm = thin;
  motion.thickestWallMm = thick;
  motion.thickeningPercent = 100 * (thick / thin - 1);
  return motion;
}

const std::vector<WallMotionRange>& wallMotionRanges() {
  const auto range = [](const char* name, const char* about, double WallMotion::*value, const char* id) {
    const anatomy::Norm& norm = anatomy::norm(id);
    const anatomy::Range normal = anatomy::rangeOf(norm);
    return WallMotionRange{
        name, about, value, normal.low, normal.high, norm.unit.c_str(), norm.source.c_str()};
  };
  static const std::vector<WallMotionRange> ranges{
      range("MAPSE", "excursion of the mitral annulus towards the apex", &WallMotion::mapseMm, "lv.mapse"),
      range("TAPSE", "excursion of the tricuspid annulus at the free wall", &WallMotion::tapseMm, "rv.tapse"),
      range("Twist", "turn of the apex against the base", &WallMotion::twistDegrees, "lv.twist"),
      range("Thickening", "of the left ventricle's free wall in systole", &WallMotion::thickeningPercent,
            "lv.thickening")};
  return ranges;
}

} // namespace viscera::heart
