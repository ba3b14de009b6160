#include "viscera/live/motion_runner.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"
#include "viscera/document/rig_commands.h"

namespace viscera::live {

MotionRunner::MotionRunner(const document::DocumentState& state, PosedOrgans& organs, Threads threads,
                           JobQueue* jobs)
    : state_(state), organs_(organs), keeper_(state, organs, threads, jobs) {}

void MotionRunner::setSequence(std::shared_ptr<const sequences::Sequence> sequence) {
  sequence_ = std::move(sequence);
  rate_ = sequence_ ? sequence_->standardRatePerMinute() : 0;
  prescribed_.reset();
  obstacle_ = {};
  ++revision_;
}

void MotionRunner::prescribe(std::optional<PrescribedVolume> volume) {
  prescribed_ = std::move(volume);
  ++revision_;
}

void MotionRunner::setRatePerMinute(double rate) {
  if (!sequence_)
    throw UsageError(misuse("There is no sequence whose rate could be set"), {},
                     misuse("choose a sequence first"));
  const double low = sequence_->lowestRatePerMinute();
  const double high = sequence_->highestRatePerMinute();
  if (!(rate >= low && rate <= high))
    throw UsageError(misuse("The rate is out of range"), sequence_->name(),
                     misuse("choose %1 to %2 a minute", inDigits(low, 6), inDigits(high, 6)));
  rate_ = rate;
  ++revision_;
}

bool MotionRunner::movable() const {
  if (!sequence_ || state_.organs->empty())
    return false;
  try {
    document::requireFits(*state_.rig, *sequence_);
    return true;
  } catch (const DataError&) {
    return false;
  }
}

void MotionRunner::requireMovable() const {
  if (!movable())
    throw UsageError(misuse("There is no sequence that could move these handles"), {},
                     misuse("choose a sequence, and use its handles"));
}

bool MotionRunner::keepsVolumes() const {
  return prescribed_ || std::any_of(state_.organs->begin(), state_.organs->end(),
                                    [](const auto& organ) { return organ->volumeLocked; });
}

deformation::RestoredPose MotionRunner::restoredPose(double seconds) {
  sequence_->poseAt(seconds, rate_, pose_);
  if (!keepsVolumes())
    return {pose_, true, 0, 0, {}};
  std::optional<AskedVolume> asked;
  if (prescribed_) {
    const double cycles = seconds / periodSeconds();
    asked = {prescribed_->organ, kMm3PerMl * prescribed_->milliliters.at(cycles - std::floor(cycles))};
  }
  return keeper_.keep(pose_, asked);
}

void MotionRunner::requireReachable() {
  for (int instant = 0; movable() && instant < kTriedInstants; ++instant) {
    const double fraction = static_cast<double>(instant) / kTriedInstants;
    const auto tried = restoredPose(fraction * periodSeconds());
    if (tried.restored)
      continue;
    Text wanted = "the locked volumes cannot be kept";
    if (prescribed_)
      wanted = phrase("%1 ml cannot be reached", std::lround(prescribed_->milliliters.at(fraction)));
    throw DataError(phrase("%1 at %2 % of the cycle: %3", wanted, std::lround(100 * fraction), tried.reason),
                    sequence_->name(),
                    "ask for a volume nearer to that at rest, or let more handles compensate");
  }
}

std::optional<Points> MotionRunner::poseAt(double seconds) {
  obstacle_ = {};
  try {
    deformation::RestoredPose kept = restoredPose(seconds);
    if (kept.restored)
      return std::move(kept.pose);
    obstacle_ = std::move(kept.reason);
    return std::nullopt;
  } catch (const DataError& error) {
    obstacle_ = error.explanation(); // An organ is still being bound: it moves on as the sequence says.
    return pose_;
  }
}

void MotionRunner::show(double seconds) {
  obstacle_ = {};
  if (!movable())
    return;
  if (const std::optional<Points> pose = poseAt(seconds))
    organs_.showPose(*pose);
}

std::vector<double> MotionRunner::volumesMl() const {
  std::vector<double> milliliters;
  for (const auto& organ : *state_.organs) {
    const OrganVolume volume = organs_.volume(organ->id);
    milliliters.push_back(volume.closed ? volume.nowMl : 0);
  }
  return milliliters;
}

} // namespace viscera::live
