#include "viscera/sequences/breathing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::sequences {
namespace {

/// The part of a breath at which expiration has all but ended: the pause follows, and lasts for as long into
/// the next breath. The liver moves by less than 2 % of its way in it.
constexpr double kPause = 0.88;
constexpr Eigen::Index kFewestBreathingHandles = 4;
constexpr double kLargestShare = 0.5;

} // namespace

LiverBreathing::LiverBreathing(Points restHandles, const Bounds& organ, std::vector<HandleGroup> groups,
                               const LiverExcursion& excursion)
    : rest_(std::move(restHandles)), middle_(organ.center()), groups_(std::move(groups)),
      excursion_(excursion) {
  if (rest_.rows() < kFewestBreathingHandles)
    throw DataError(misuse("breathing needs at least four handles"), "breathing");
  if (!rest_.allFinite() || !(organ.diagonal() > 0))
    throw DataError("the organ has no extent", "breathing");
  if (!(std::abs(excursion.domeShare) <= kLargestShare) || !(std::abs(excursion.rightShare) <= kLargestShare))
    throw DataError(misuse("the liver cannot be pressed that far"), "breathing",
                    misuse("use shares between 0 and 0.5"));
}

double LiverBreathing::inspiration(double seconds, double ratePerMinute) const {
  const double rate = std::clamp(ratePerMinute, lowestRatePerMinute(), highestRatePerMinute());
  // sin^4(pi t / T): a breath of period T that rests long at its end.
  const double wave = std::sin(std::numbers::pi * seconds * rate / 60);
  return wave * wave * wave * wave;
}

Vec3 LiverBreathing::moved(const Vec3& point, double inspiration) const {
  const Vec3 from = point - middle_;
  const double height = 1 - inspiration * excursion_.domeShare;
  // The width balances the loss of height, so that the determinant stays 1.
  const double width = 1 / std::sqrt(height);
  // The patient's right is -x in LPS.
  const double tilt = inspiration * excursion_.rightShare * from.x();
  return middle_ + Vec3(width * from.x(), width * from.y() - inspiration * excursion_.forwardMm,
                        height * from.z() + tilt - inspiration * excursion_.downMm);
}

void LiverBreathing::poseAt(double seconds, double ratePerMinute, Points& pose) const {
  const double drawn = inspiration(seconds, ratePerMinute);
  pose.resize(rest_.rows(), 3);
  for (Eigen::Index i = 0; i < rest_.rows(); ++i)
    pose.row(i) = moved(rest_.row(i).transpose(), drawn);
}

std::vector<Phase> LiverBreathing::phases(double) const {
  return {{"pause", 0, 1 - kPause},
          {"inspiration", 1 - kPause, 0.5},
          {"expiration", 0.5, kPause},
          {"pause", kPause, 1}};
}

} // namespace viscera::sequences
