#include "viscera/heart/outer_heartbeat.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "viscera/core/cubic_root.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"

namespace viscera::heart {
namespace {

constexpr double kLargestLoss = 0.4;
/// The ventricles may become narrower or wider by that part of their distance from the axis.
constexpr double kMostHeartWidening = 0.5;
/// Behind the base widening fades within this length of the axis, mm.
constexpr double kBaseFading = 30;
constexpr int kTriedOfAHeart = 48;

bool widens(HeartRole role) {
  return role == HeartRole::epicardium || role == HeartRole::atrium;
}

} // namespace

OuterHeartbeat::OuterHeartbeat(HeartMotion motion, sequences::PoseCompensation compensation,
                               sequences::VolumeAlong volume, double systolicLoss)
    : Heartbeat(CardiacCycle()), motion_(std::move(motion)), compensation_(std::move(compensation)),
      rest_(motion_.rig().restHandles()), volume_(std::move(volume)), loss_(systolicLoss) {
  compensation_.requireFor(rest_.rows(), "heart", "heartbeat");
  if (!(loss_ >= 0 && loss_ <= kLargestLoss))
    throw DataError(misuse("a heart cannot lose that part of its volume in systole"), "heartbeat",
                    misuse("choose 0 to 0.4; people have 0.048 to 0.106"));
  restMl_ = volume_(rest_, Points::Zero(rest_.rows(), 3))[0];
  Points pose;
  for (int i = 0; i < kTriedOfAHeart; ++i)
    poseAt(i * 60 / CardiacCycle::kStandardRateBpm / kTriedOfAHeart, CardiacCycle::kStandardRateBpm, pose);
}

void OuterHeartbeat::poseAt(double seconds, double ratePerMinute, Points& pose) const {
  const HeartInstant now = heartInstant(cycle(), cycle().at(seconds, ratePerMinute));
  motion_.pose(now.state, pose);
  const HeartFrame& frame = motion_.rig().anatomy.frame;
  Points widened = rest_;
  for (Eigen::Index i = 0; i < pose.rows(); ++i) {
    const HeartHandle& handle = motion_.rig().handles[static_cast<std::size_t>(i)];
    if (!widens(handle.role))
      continue;
    const Vec3 from = pose.row(i).transpose() - frame.origin();
    const Vec3 outward = from - from.dot(frame.towardsApex()) * frame.towardsApex();
    widened.row(i) += sequences::smoothStep(1 + handle.place.c / kBaseFading) * outward.transpose();
  }
  compensation_.apply(rest_, pose);
  compensation_.apply(rest_, widened);
  const Points added = widened - rest_;
  const double wanted = restMl_ * (1 - loss_ * now.state.emptying);
  // V(pose + x added) - V_rest (1 - loss emptying) = 0, a cubic in x.
  std::array<double, 4> missing = volume_(pose, added);
  missing[0] -= wanted;
  const auto root = nearestCubicRoot(missing, -kMostHeartWidening, kMostHeartWidening);
  if (!root)
    throw DataError("the heart cannot be brought to the volume that it has to hold",
                    phrase("heartbeat at %1 s", inFixed(seconds, 3)), "check the landmarks of apex and base");
  pose += *root * added;
}

} // namespace viscera::heart
