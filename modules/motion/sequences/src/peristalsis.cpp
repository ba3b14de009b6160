#include "viscera/sequences/peristalsis.h"

#include <cmath>
#include <utility>

#include "viscera/core/cubic_root.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"

namespace viscera::sequences {
namespace {

// The bell over the upper stomach that takes in what waves press out: its middle as a part of the way from
// the top to the middle of the body, and its width (one standard deviation).
constexpr double kReservoirMiddle = 0.545;
constexpr double kReservoirWidth = 0.415;

constexpr double kLeastWidening = -0.5;
constexpr double kMostTubeWidening = 0.8;
constexpr int kTriedOfAWave = 40;

bool moves(const StomachHandle& handle) {
  return handle.region != StomachRegion::fixed && handle.region != StomachRegion::farCorner;
}

} // namespace

Peristalsis::Peristalsis(StomachRig rig, PoseCompensation compensation, VolumeAlong volume)
    : rig_(std::move(rig)), compensation_(std::move(compensation)), volume_(std::move(volume)),
      waves_(rig_.anatomy.course), rest_(rig_.restHandles()) {
  compensation_.requireFor(rest_.rows(), "stomach", "peristalsis");
  keptMl_ = volume_(rest_, Points::Zero(rest_.rows(), 3))[0];
  const double cycle = 60 / standardRatePerMinute();
  for (int i = 0; i < kTriedOfAWave; ++i)
    widening(i * cycle / kTriedOfAWave, standardRatePerMinute());
}

void Peristalsis::affinePose(double seconds, double ratePerMinute, Points& narrowed, Points& added) const {
  const double middle = kReservoirMiddle * waves_.course().midBody;
  const double width = kReservoirWidth * waves_.course().midBody;
  narrowed = rest_;
  Points widened = rest_;
  for (Eigen::Index i = 0; i < rest_.rows(); ++i) {
    const StomachHandle& handle = rig_.handles[static_cast<std::size_t>(i)];
    if (!moves(handle))
      continue;
    const double away = (handle.s - middle) / width;
    const double open = 1 - waves_.constriction(handle.s, seconds, ratePerMinute);
    const Vec3 outward = open * (handle.position - handle.center);
    narrowed.row(i) = handle.center + outward;
    widened.row(i) = handle.position + std::exp(-0.5 * away * away) * outward;
  }
  compensation_.apply(rest_, narrowed);
  compensation_.apply(rest_, widened);
  added = widened - rest_;
}

double Peristalsis::wideningFor(const Points& narrowed, const Points& added, double seconds) const {
  // V(narrowed + x added) - V_kept = 0, a cubic in x.
  std::array<double, 4> missing = volume_(narrowed, added);
  missing[0] -= keptMl_;
  const auto root = nearestCubicRoot(missing, kLeastWidening, kMostTubeWidening);
  if (!root)
    throw DataError("the upper stomach cannot take in what the waves press out",
                    phrase("peristalsis after %1 s", inFixed(seconds, 3)), "check the landmarks");
  return *root;
}

double Peristalsis::widening(double seconds, double ratePerMinute) const {
  Points narrowed;
  Points added;
  affinePose(seconds, ratePerMinute, narrowed, added);
  return wideningFor(narrowed, added, seconds);
}

void Peristalsis::poseAt(double seconds, double ratePerMinute, Points& pose) const {
  Points added;
  affinePose(seconds, ratePerMinute, pose, added);
  pose += wideningFor(pose, added, seconds) * added;
}

} // namespace viscera::sequences
