#include "viscera/live/player.h"

#include <chrono>
#include <cmath>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::live {
namespace {
constexpr double kFastestSpeed = 10;

void requirePlace(double fraction) {
  if (!(fraction >= 0 && fraction <= 1))
    throw UsageError(misuse("A place in the cycle lies between 0 and 1"));
}
} // namespace

Player::Clock Player::steadyClock() {
  return [] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  };
}

Player::Player(const document::DocumentState& state, LiveBinding& live, Clock clock, JobQueue* jobs)
    : time_(std::make_shared<Time>(Time{std::move(clock)})), state_(state), live_(live),
      runner_(state, live, {}, jobs) {
  time_->players.push_back(this);
}

Player::Player(Player& joined, const document::DocumentState& state, LiveBinding& live, JobQueue* jobs)
    : time_(joined.time_), state_(state), live_(live), runner_(state, live, {}, jobs) {
  time_->players.push_back(this);
}

Player::~Player() {
  std::erase(time_->players, this);
}

void Player::setSequence(std::shared_ptr<const sequences::Sequence> sequence, document::OrganId organ) {
  runner_.setSequence(std::move(sequence));
  organ_ = organ;
  fraction_ = 0;
  if (leads()) {
    time_->running = time_->started = false;
    time_->played = 0;
  }
  placeOthers();
}

void Player::exchangeSequence(std::shared_ptr<const sequences::Sequence> sequence) {
  passTime(); // Time up to now belongs to the previous sequence.
  std::optional<PrescribedVolume> prescribed = runner_.prescribed();
  runner_.setSequence(std::move(sequence));
  runner_.prescribe(std::move(prescribed));
  placeOthers();
}

const sequences::Sequence* Player::sequence() const {
  return state_.organ(organ_) ? runner_.sequence().get() : nullptr;
}

bool Player::showing() const {
  return time_->started && time_->pose == WantedPose::sequence && movable();
}

void Player::setRatePerMinute(double rate) {
  passTime(); // Time up to now belongs to the previous rate.
  runner_.setRatePerMinute(rate);
  placeOthers();
  showAll();
  time_->state.emit();
}

void Player::prescribe(const std::optional<PrescribedVolume>& volume) {
  const auto before = runner_.prescribed();
  runner_.prescribe(volume);
  try {
    if (volume)
      runner_.requireReachable();
  } catch (...) {
    runner_.prescribe(before);
    throw;
  }
  match();
}

Text Player::phase() const {
  if (!sequence())
    return {};
  for (const sequences::Phase& phase : runner_.sequence()->phases(ratePerMinute()))
    if (fraction_ < phase.end)
      return fraction_ >= phase.begin ? phase.name : Text();
  return {};
}

bool Player::ready() const {
  return time_->pose == WantedPose::sequence && first().movable();
}

void Player::play() {
  if (time_->running || !ready())
    return;
  if (first().fraction_ >= 1) {
    rewind();
    placeOthers();
  }
  time_->lastClock = time_->clock();
  time_->running = time_->started = true;
  showAll();
  time_->state.emit();
}

void Player::pause() {
  if (std::exchange(time_->running, false))
    time_->state.emit();
}

void Player::stop() {
  const bool was = std::exchange(time_->started, false);
  if (!std::exchange(time_->running, false) && !was)
    return;
  rewind();
  placeOthers();
  showAll();
  time_->state.emit();
}

bool Player::advance() {
  const bool was = time_->running;
  const bool moved = passTime();
  if (moved)
    showAll();
  if (was && !time_->running)
    time_->state.emit();
  return moved;
}

void Player::seek(double fraction) {
  requirePlace(fraction);
  if (ready())
    setPlace(fraction);
}

void Player::setPlace(double fraction) {
  requirePlace(fraction);
  if (!first().movable())
    return;
  const bool was = std::exchange(time_->started, true);
  first().fraction_ = time_->loop && fraction >= 1 ? 0 : fraction;
  time_->played = 0;
  time_->lastClock = time_->clock();
  placeOthers();
  showAll();
  if (!was)
    time_->state.emit();
}

void Player::step(double seconds) {
  pause();
  if (!ready())
    return;
  const double moved = first().fraction_ + seconds / first().periodSeconds();
  seek(moved - std::floor(moved));
}

void Player::setPose(WantedPose pose) {
  time_->pose = pose;
  if (pose != WantedPose::sequence)
    pause();
  showAll();
}

void Player::setLoop(bool loop) {
  time_->loop = loop;
  time_->state.emit();
}

void Player::setSpeed(double speed) {
  if (!(speed > 0 && speed <= kFastestSpeed))
    throw UsageError(misuse("The speed is out of range"), {},
                     misuse("choose more than 0 and up to 10 times"));
  const bool moved = passTime();
  time_->speed = speed;
  if (moved)
    showAll();
  time_->state.emit();
}

void Player::match() {
  if (time_->started && !first().movable()) {
    time_->running = time_->started = false;
    rewind();
    placeOthers();
  }
  showAll();
  time_->state.emit();
}

/// Moves the places of all views up to the clock.
bool Player::passTime() {
  if (!time_->running)
    return false;
  const double now = time_->clock();
  double passed = (now - std::exchange(time_->lastClock, now)) * time_->speed;
  if (!(passed > 0))
    return false;
  const double left = (1 - first().fraction_) * first().periodSeconds();
  const bool ends = !time_->loop && passed >= left;
  passed = ends ? left : passed;
  time_->played += passed;
  for (Player* player : time_->players)
    player->pass(passed);
  if (ends) {
    first().fraction_ = 1;
    time_->running = false;
  }
  return true;
}

void Player::pass(double seconds) {
  if (periodSeconds() <= 0)
    return;
  const double ahead = fraction_ + seconds / periodSeconds();
  fraction_ = ahead - std::floor(ahead);
}

void Player::rewind() {
  time_->played = 0;
  first().fraction_ = 0;
}

/// The other views go to the seconds at which the first one is.
void Player::placeOthers() {
  const double seconds = first().secondsInCycle();
  for (Player* player : time_->players)
    if (!player->leads() && player->periodSeconds() > 0)
      player->fraction_ = std::fmod(seconds, player->periodSeconds()) / player->periodSeconds();
}

void Player::showAll() {
  FirstException problem;
  for (Player* player : time_->players)
    problem.watch([player] { player->showOwn(); });
  if (time_->started && time_->pose == WantedPose::sequence)
    time_->shown.emit();
  problem.rethrow();
}

void Player::showOwn() {
  if (time_->pose == WantedPose::rest)
    live_.showRest();
  else if (showing())
    runner_.show(secondsInCycle());
  else
    live_.showDocumentPose();
}

} // namespace viscera::live
