#include "viscera/motion/transport.h"

#include <chrono>
#include <cmath>
#include <exception>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/motion/player.h"

namespace viscera::motion {
namespace {
constexpr double kFastestSpeed = 10;

void requirePlace(double fraction) {
  if (!(fraction >= 0 && fraction <= 1))
    throw UsageError("A place in the cycle lies between 0 and 1");
}
} // namespace

Transport::Clock Transport::steadyClock() {
  return [] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  };
}

Transport::Transport(Clock clock) : clock_(std::move(clock)) {}

bool Transport::ready() const {
  return pose_ == WantedPose::sequence && !players_.empty() && players_.front()->movable();
}

void Transport::play() {
  if (playing_ || !ready())
    return;
  if (players_.front()->fraction_ >= 1) {
    rewind();
    placeOthers();
  }
  lastClock_ = clock_();
  playing_ = started_ = true;
  show();
  state_.emit();
}

void Transport::pause() {
  if (std::exchange(playing_, false))
    state_.emit();
}

void Transport::stop() {
  const bool was = std::exchange(started_, false);
  if (!std::exchange(playing_, false) && !was)
    return;
  rewind();
  placeOthers();
  show();
  state_.emit();
}

/// Moves the positions up to the clock.
bool Transport::passTime() {
  if (!playing_)
    return false;
  const double now = clock_();
  double passed = (now - std::exchange(lastClock_, now)) * speed_;
  if (!(passed > 0))
    return false;
  Player& first = *players_.front();
  const double left = (1 - first.fraction_) * first.periodSeconds();
  const bool ends = !loop_ && passed >= left;
  passed = ends ? left : passed;
  played_ += passed;
  for (Player* player : players_)
    player->pass(passed);
  if (ends) {
    first.fraction_ = 1;
    playing_ = false;
  }
  return true;
}

bool Transport::advance() {
  const bool was = playing_;
  const bool moved = passTime();
  if (moved)
    show();
  if (was && !playing_)
    state_.emit();
  return moved;
}

void Transport::seek(double fraction) {
  requirePlace(fraction);
  if (ready())
    setPlace(fraction);
}

void Transport::setPlace(double fraction) {
  requirePlace(fraction);
  if (players_.empty() || !players_.front()->movable())
    return;
  const bool was = std::exchange(started_, true);
  players_.front()->fraction_ = loop_ && fraction >= 1 ? 0 : fraction;
  played_ = 0;
  lastClock_ = clock_();
  placeOthers();
  show();
  if (!was)
    state_.emit();
}

void Transport::step(double seconds) {
  pause();
  if (!ready())
    return;
  const double moved = players_.front()->fraction_ + seconds / players_.front()->periodSeconds();
  seek(moved - std::floor(moved));
}

void Transport::setPose(WantedPose pose) {
  pose_ = pose;
  if (pose_ != WantedPose::sequence)
    pause();
  show();
}

void Transport::setLoop(bool loop) {
  loop_ = loop;
  state_.emit();
}

void Transport::setSpeed(double speed) {
  if (!(speed > 0 && speed <= kFastestSpeed))
    throw UsageError("The speed is out of range", {}, "choose more than 0 and up to 10 times");
  const bool moved = passTime();
  speed_ = speed;
  if (moved)
    show();
  state_.emit();
}

void Transport::rewind() {
  played_ = 0;
  if (!players_.empty())
    players_.front()->fraction_ = 0;
}

/// The other views go to the seconds at which the first one is.
void Transport::placeOthers() {
  if (players_.empty())
    return;
  const double seconds = players_.front()->secondsInCycle();
  for (Player* player : players_)
    if (player != players_.front() && player->periodSeconds() > 0)
      player->fraction_ = std::fmod(seconds, player->periodSeconds()) / player->periodSeconds();
}

void Transport::match() {
  if (started_ && !players_.front()->movable()) {
    playing_ = started_ = false;
    rewind();
    placeOthers();
  }
  show();
  state_.emit();
}

void Transport::show() {
  std::exception_ptr problem;
  for (Player* player : players_) {
    try {
      player->show();
    } catch (...) {
      problem = std::current_exception();
    }
  }
  if (showing())
    shown_.emit();
  if (problem)
    std::rethrow_exception(problem);
}

} // namespace viscera::motion
