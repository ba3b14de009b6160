#include "viscera/motion/player.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <sstream>
#include <utility>

#include "viscera/core/error.h"

namespace viscera::motion {
namespace {

constexpr double kFastestSpeed = 10;

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

} // namespace viscera::motion
