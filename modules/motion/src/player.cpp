#include "viscera/motion/player.h"

#include <cmath>
#include <optional>
#include <utility>

namespace viscera::motion {

Player::Player(Transport& transport, const document::DocumentState& state, live::LiveBinding& live,
               JobQueue* jobs)
    : transport_(transport), state_(state), live_(live), runner_(state, live, {}, jobs) {
  transport_.players_.push_back(this);
}

Player::~Player() {
  std::erase(transport_.players_, this);
}

void Player::setSequence(std::shared_ptr<const sequences::Sequence> sequence, document::OrganId organ) {
  runner_.setSequence(std::move(sequence));
  organ_ = organ;
  fraction_ = 0;
  if (transport_.players_.front() == this) {
    transport_.playing_ = transport_.started_ = false;
    transport_.played_ = 0;
  }
  transport_.placeOthers();
}

void Player::exchangeSequence(std::shared_ptr<const sequences::Sequence> sequence) {
  transport_.passTime(); // Time up to now belongs to the previous sequence.
  std::optional<PrescribedVolume> prescribed = runner_.prescribed();
  runner_.setSequence(std::move(sequence));
  runner_.prescribe(std::move(prescribed));
  transport_.placeOthers();
}

const sequences::Sequence* Player::sequence() const {
  return state_.organ(organ_) ? runner_.sequence().get() : nullptr;
}

void Player::setRatePerMinute(double rate) {
  transport_.passTime(); // Time up to now belongs to the previous rate.
  runner_.setRatePerMinute(rate);
  transport_.placeOthers();
  transport_.show();
  transport_.state_.emit();
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
  transport_.match();
}

std::string Player::phase() const {
  if (!sequence())
    return {};
  for (const sequences::Phase& phase : runner_.sequence()->phases(ratePerMinute()))
    if (fraction_ < phase.end)
      return fraction_ >= phase.begin ? phase.name : std::string();
  return {};
}

void Player::pass(double seconds) {
  if (periodSeconds() <= 0)
    return;
  const double ahead = fraction_ + seconds / periodSeconds();
  fraction_ = ahead - std::floor(ahead);
}

void Player::show() {
  if (transport_.pose() == WantedPose::rest)
    live_.showRest();
  else if (showing())
    runner_.show(secondsInCycle());
  else
    live_.showDocumentPose();
}

} // namespace viscera::motion
