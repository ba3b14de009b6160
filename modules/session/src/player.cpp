#include "viscera/session/player.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <sstream>
#include <utility>

#include "viscera/core/error.h"

namespace viscera::session {
namespace {

constexpr double kFastestSpeed = 10;
/// Handles apart by more than this part of the rig's size are other handles.
constexpr double kSameRest = 1e-6;

std::string rangeText(double low, double high, const std::string& unit) {
  std::ostringstream text;
  text << "choose " << low << " to " << high << " " << unit;
  return text.str();
}

} // namespace

Player::Clock Player::steadyClock() {
  return [] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  };
}

Player::Player(Clock clock) : clock_(std::move(clock)) {}

void Player::setSequence(std::shared_ptr<const sequences::Sequence> sequence) {
  sequence_ = std::move(sequence);
  rate_ = sequence_ ? sequence_->standardRatePerMinute() : 0;
  playing_ = false;
  fraction_ = 0;
  played_ = 0;
}

void Player::play() {
  if (!sequence_ || playing_)
    return;
  if (fraction_ >= 1)
    fraction_ = 0;
  lastClock_ = clock_();
  playing_ = true;
}

void Player::pause() {
  advance();
  playing_ = false;
}

void Player::setRatePerMinute(double rate) {
  if (!sequence_)
    throw UsageError("There is no sequence whose rate could be set", {}, "choose a sequence first");
  const double low = sequence_->lowestRatePerMinute();
  const double high = sequence_->highestRatePerMinute();
  if (!(rate >= low && rate <= high))
    throw UsageError("The rate is out of range", sequence_->name(), rangeText(low, high, "a minute"));
  advance(); // What has passed, passed at the rate before.
  rate_ = rate;
}

void Player::setSpeed(double speed) {
  if (!(speed > 0 && speed <= kFastestSpeed))
    throw UsageError("The speed is out of range", {}, rangeText(0, kFastestSpeed, "times (0 excluded)"));
  advance();
  speed_ = speed;
}

void Player::seek(double fraction) {
  if (!(fraction >= 0 && fraction <= 1))
    throw UsageError("A place in the cycle lies between 0 and 1");
  fraction_ = loop_ && fraction >= 1 ? 0 : fraction;
  played_ = 0;
  if (playing_)
    lastClock_ = clock_();
}

bool Player::advance() {
  if (!playing_)
    return false;
  const double now = clock_();
  const double passed = (now - lastClock_) * speed_;
  lastClock_ = now;
  if (passed <= 0)
    return false;
  const double ahead = fraction_ + passed / periodSeconds();
  if (loop_) {
    played_ += passed;
    fraction_ = ahead - std::floor(ahead);
  } else {
    played_ += std::min(passed, (1 - fraction_) * periodSeconds());
    fraction_ = std::min(ahead, 1.0);
    playing_ = fraction_ < 1;
  }
  return true;
}

double Player::secondsInCycle() const {
  return fraction_ * periodSeconds();
}

std::string Player::phase() const {
  if (!sequence_)
    return {};
  for (const sequences::Phase& phase : sequence_->phases(rate_))
    if (fraction_ < phase.end)
      return fraction_ >= phase.begin ? phase.name : std::string();
  return {};
}

void Player::pose(Points& pose) const {
  assert(sequence_ && "a player without a sequence has no pose");
  sequence_->poseAt(secondsInCycle(), rate_, pose);
}

void requireFits(const Rig& rig, const sequences::Sequence& sequence) {
  const Points& own = sequence.restHandles();
  const Points rest = rig.restPositions();
  const std::string advice = "take the sequence's own handles";
  if (own.rows() != rest.rows())
    throw DataError("The sequence moves " + std::to_string(own.rows()) + " handles, but there are " +
                        std::to_string(rest.rows()),
                    sequence.name(), advice);
  const double size = std::max(boundsOf(own).diagonal(), 1.0);
  for (Eigen::Index i = 0; i < rest.rows(); ++i)
    if (!((own.row(i) - rest.row(i)).norm() <= kSameRest * size))
      throw DataError("The sequence was made for another place of a handle",
                      sequence.name() + ", handle " + rig.handles[static_cast<std::size_t>(i)].label, advice);
}

NewRig rigOf(const sequences::Sequence& sequence) {
  NewRig rig;
  rig.handles = newHandles(sequence.restHandles());
  for (const sequences::HandleGroup& group : sequence.groups()) {
    rig.groups.push_back({group.name, group.color, group.handles});
    int number = 0;
    for (const int handle : group.handles)
      rig.handles[static_cast<std::size_t>(handle)].label = group.name + " " + std::to_string(++number);
  }
  if (rig.groups.empty()) {
    NewGroup all{sequence.name(), {1.0, 0.5, 0.2}, {}};
    for (std::size_t i = 0; i < rig.handles.size(); ++i)
      all.handles.push_back(static_cast<int>(i));
    rig.groups.push_back(std::move(all));
  }
  return rig;
}

} // namespace viscera::session
