#include "viscera/heart/heart_valves.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <Eigen/Geometry>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/heart/heart_frame.h"
#include "viscera/sequences/curve.h"

namespace viscera::heart {
namespace {

constexpr double kMm2PerCm2 = 100;
/// Areas of healthy adults, cm2, in the order of `HeartValve`.
constexpr std::array<double, kHeartValves> kNormalCm2 = {5, 4, 6, 4};
/// How long leaflets are on their way.
constexpr double kMovingSeconds = 0.04;
/// Leaflets that have hardly begun to move leave at least what this speed needs.
constexpr double kFastestMmPerS = 1200;
/// The step over which the textbook's volumes are differentiated.
constexpr double kStepSeconds = 1e-3;

/// Vertices within so many radii of a ring carry it, but at least so many.
constexpr double kReach = 1.3;
constexpr std::size_t kFewestAnchors = 24;

double mod(double value, double period) {
  return value - period * std::floor(value / period);
}

/// How far a valve is open that opens and shuts then.
double opening(double seconds, double opens, double shuts, double cycle) {
  const double since = mod(seconds - opens, cycle);
  const double stays = mod(shuts - opens, cycle);
  if (since >= stays)
    return 0;
  const double moving = std::min(kMovingSeconds, stays / 2);
  return sequences::smoothStep(since / moving) * sequences::smoothStep((stays - since) / moving);
}

ValveRing ringAt(const HeartFrame& frame, const Vec3& center, const Vec3& downstream, const Vec3& along,
                 double first, double second) {
  const auto turned = [&frame](const Vec3& local) -> Vec3 { return frame.toWorld(local) - frame.origin(); };
  ValveRing ring;
  ring.center = frame.toWorld(center);
  ring.downstream = turned(downstream).normalized();
  const Vec3 direction = turned(along);
  ring.first = first * (direction - direction.dot(ring.downstream) * ring.downstream).normalized();
  ring.second = second * ring.downstream.cross(ring.first).normalized();
  return ring;
}

} // namespace

ValveInstants textbookValves(const CardiacBeat& beat, double seconds) {
  const CavityVolumes before = beat.at(seconds - kStepSeconds).volumes;
  const CavityVolumes after = beat.at(seconds + kStepSeconds).volumes;
  const double left = (after.leftMl - before.leftMl) / (2 * kStepSeconds);
  const double right = (after.rightMl - before.rightMl) / (2 * kStepSeconds);
  const double cycle = beat.times().cycle;
  const auto inlet = [&](const VentricleClock& clock) {
    return opening(seconds, clock.inletOpens, clock.inletShuts, cycle);
  };
  const auto outlet = [&](const VentricleClock& clock) {
    return opening(seconds, clock.outletOpens, clock.outletShuts, cycle);
  };
  const std::array<double, kHeartValves> open = {inlet(beat.left()), outlet(beat.left()), inlet(beat.right()),
                                                 outlet(beat.right())};
  const std::array<double, kHeartValves> flow = {left, -left, right, -right};
  ValveInstants valves;
  for (std::size_t i = 0; i < kHeartValves; ++i) {
    const double flows = open[i] > 0 ? std::max(0.0, flow[i]) : 0.0;
    const double full = kMm2PerCm2 * kNormalCm2[i];
    valves[i] = {std::max(full * open[i], std::min(full, kMm3PerMl * flows / kFastestMmPerS)), flows};
  }
  return valves;
}

double ValveRing::areaMm2() const {
  return std::numbers::pi * first.norm() * second.norm();
}

double ValveRing::radius() const {
  return std::sqrt(first.norm() * second.norm());
}

ValveRings sampleHeartRings() {
  const HeartFrame frame = sampleHeartFrame();
  // The base of the left cavity is a disc of 22.7 mm; the aorta lies on its side towards the septum and the
  // head.
  const Vec3 towardsAorta(0.6, -0.8, 0);
  ValveRings rings;
  rings[0] = ringAt(frame, {-5.2, 7.0, 1}, {0, 0, 1}, towardsAorta, 12, 14.5);
  rings[1] = ringAt(frame, {7.5, -10, -4}, {0.28, -0.38, -0.88}, towardsAorta, 12, 12);
  // The tricuspid ring lies 6 mm nearer to the apex at the septum, at the free wall as high.
  rings[2] = ringAt(frame, {40.6, 14.2, 3.5}, {0.264, 0.0924, 0.96}, {0.906, 0.317, -0.28}, 12, 16);
  rings[3] = ringAt(frame, {28, -37, 18}, {-0.36, -0.81, -0.46}, {1, 0, 0}, 11.8, 11.8);
  return rings;
}

CarriedRing::CarriedRing(const ValveRing& rest, const Points& surface) : rest_(rest) {
  const auto count = static_cast<std::size_t>(surface.rows());
  if (count < 3)
    throw DataError(misuse("a surface needs three points at least to carry the ring of a valve"), "heart");
  const auto farness = [&](Eigen::Index i) { return (surface.row(i).transpose() - rest.center).norm(); };
  anchors_.resize(count);
  std::iota(anchors_.begin(), anchors_.end(), Eigen::Index{0});
  std::stable_sort(anchors_.begin(), anchors_.end(),
                   [&](Eigen::Index a, Eigen::Index b) { return farness(a) < farness(b); });
  const double reach = kReach * rest.radius();
  const auto near = static_cast<std::size_t>(
      std::partition_point(anchors_.begin(), anchors_.end(), [&](auto i) { return farness(i) < reach; }) -
      anchors_.begin());
  anchors_.resize(std::min(count, std::max(near, kFewestAnchors)));
  atRest_.resize(3, static_cast<Eigen::Index>(anchors_.size()));
  for (std::size_t i = 0; i < anchors_.size(); ++i)
    atRest_.col(static_cast<Eigen::Index>(i)) = surface.row(anchors_[i]).transpose();
}

ValveRing CarriedRing::at(const Points& surface) const {
  Eigen::Matrix3Xd now(3, atRest_.cols());
  for (std::size_t i = 0; i < anchors_.size(); ++i)
    now.col(static_cast<Eigen::Index>(i)) = surface.row(anchors_[i]).transpose();
  // The similarity of least sum |s R x_i + t - y_i|^2 (Umeyama 1991): the ring follows the wall's place, turn
  // and size, and not its dents.
  const Eigen::Matrix4d moved = Eigen::umeyama(atRest_, now, true);
  const Eigen::Matrix3d turned = moved.topLeftCorner<3, 3>();
  return {turned * rest_.center + moved.topRightCorner<3, 1>(), turned * rest_.first, turned * rest_.second,
          (turned * rest_.downstream).normalized()};
}

} // namespace viscera::heart
