#include "window/timeline/playback.h"

#include <algorithm>
#include <cmath>

#include "viscera/document/rig_commands.h"
#include "viscera/document/sequence_rig.h"

namespace viscera::app {
namespace {
constexpr int kFrameMilliseconds = 16;
constexpr double kStepSeconds = 1.0 / 25.0;
/// A motion holds coordinates of its organ: tens of megabytes.
constexpr std::size_t kMostMotions = 8;
} // namespace

Playback::Playback(Workspace& workspace, motion::Player::Clock clock, QObject* parent)
    : QObject(parent), workspace_(workspace), player_(std::move(clock)),
      keeper_(workspace.document(), workspace.live()) {
  frames_.setTimerType(Qt::PreciseTimer);
  frames_.setInterval(kFrameMilliseconds);
  connect(&frames_, &QTimer::timeout, this, &Playback::advance);
  subscription_ = workspace.onChange([this](const document::Change& change) {
    if (started_ && (change.rig() || !sequence()))
      stop();
    if (change.organs()) {
      takeWhatFits();
      Q_EMIT stateChanged();
    }
  });
}

void Playback::setSequence(std::shared_ptr<const sequences::Sequence> sequence, document::OrganId organ,
                           std::string recipe) {
  stop();
  const Motion motion{std::move(sequence), organ, std::move(recipe)};
  remember(motion);
  take(motion);
  Q_EMIT stateChanged();
}

void Playback::offer(std::shared_ptr<const sequences::Sequence> sequence, document::OrganId organ,
                     std::string recipe) {
  remember({std::move(sequence), organ, std::move(recipe)});
  Q_EMIT stateChanged();
}

void Playback::remember(const Motion& motion) {
  if (!motion.sequence)
    return;
  if (known_.size() >= kMostMotions)
    known_.erase(known_.begin());
  known_.push_back(motion);
}

void Playback::forget(const sequences::Sequence* sequence) {
  std::erase_if(known_, [sequence](const Motion& motion) { return motion.sequence.get() == sequence; });
  if (present_.sequence.get() != sequence)
    return;
  stop();
  take({});
  takeWhatFits();
  Q_EMIT stateChanged();
}

void Playback::forgetAll() {
  stop();
  known_.clear();
  take({});
  Q_EMIT stateChanged();
}

std::vector<Playback::Motion> Playback::motions() const {
  std::vector<Motion> there;
  for (const Motion& motion : known_)
    if (workspace_.document().organ(motion.organ))
      there.push_back(motion);
  return there;
}

void Playback::choose(const sequences::Sequence* sequence) {
  for (const Motion& motion : motions()) {
    if (motion.sequence.get() != sequence || present_.sequence == motion.sequence)
      continue;
    stop();
    take(motion);
    Q_EMIT stateChanged();
    return;
  }
}

void Playback::take(const Motion& motion) {
  present_ = motion;
  player_.setSequence(present_.sequence);
}

/// Organs came or went: the youngest motion whose organ is there, unless the present one's still is.
void Playback::takeWhatFits() {
  if (sequence())
    return;
  const std::vector<Motion> there = motions();
  if (!there.empty())
    take(there.back());
}

const sequences::Sequence* Playback::sequence() const {
  return workspace_.document().organ(present_.organ) ? present_.sequence.get() : nullptr;
}

void Playback::setFollower(Playback* follower) {
  if (follower_) {
    follower_->pause();
    follower_->driven_ = false;
  }
  follower_ = follower;
  if (!follower_)
    return;
  follower_->driven_ = true;
  follower_->frames_.stop();
  follower_->setPose(wanted_);
  follower_->setSpeed(player_.speed());
  if (showing())
    follower_->lookAtSecond(player_.secondsInCycle());
  if (player_.playing())
    follower_->play();
}

void Playback::advance() {
  const bool moved = player_.advance();
  if (follower_)
    follower_->advance();
  if (moved)
    showPose();
  if (!player_.playing() && !driven_)
    pause();
}

void Playback::setPose(WantedPose wanted) {
  wanted_ = wanted;
  if (!follows())
    pause();
  if (follower_)
    follower_->setPose(wanted);
  showWhatIsWanted();
}

void Playback::showWhatIsWanted() {
  workspace_.guarded([this] {
    if (wanted_ == WantedPose::rest)
      workspace_.live().showRest();
    else if (showing())
      showPose();
    else
      workspace_.live().showDocumentPose();
  });
}

bool Playback::start() {
  if (!sequence())
    return false;
  try {
    document::requireFits(workspace_.document().rig(), *present_.sequence);
  } catch (const Error&) {
    offerOwnHandles();
    return false;
  }
  if (!follows())
    Q_EMIT playModeWanted();
  started_ = follows();
  return started_;
}

void Playback::offerOwnHandles() {
  Message message;
  message.severity = Message::Severity::warning;
  message.text =
      tr("%1 moves handles of its own, and these are others.").arg(text(present_.sequence->name()));
  message.offers.push_back(
      {tr("Use its handles"), [this] {
         if (workspace_.perform(document::replaceRig(document::rigOf(*present_.sequence),
                                                     tr("Use the sequence's handles").toStdString())))
           play();
       }});
  workspace_.say(message);
}

void Playback::play() {
  if (player_.playing() || !start())
    return;
  player_.play();
  if (!driven_)
    frames_.start();
  if (follower_)
    follower_->play();
  showPose();
  Q_EMIT stateChanged();
}

void Playback::pause() {
  const bool was = player_.playing() || frames_.isActive();
  player_.pause();
  frames_.stop();
  if (follower_)
    follower_->pause();
  if (was)
    Q_EMIT stateChanged();
}

void Playback::toggle() {
  if (player_.playing())
    pause();
  else
    play();
}

void Playback::setLooping(bool looping) {
  player_.setLoop(looping);
  Q_EMIT stateChanged();
}

void Playback::setRate(double perMinute) {
  workspace_.guarded([&] { player_.setRatePerMinute(perMinute); });
  Q_EMIT stateChanged();
  if (showing())
    showPose();
}

void Playback::setSpeed(double speed) {
  workspace_.guarded([&] { player_.setSpeed(speed); });
  if (follower_)
    follower_->setSpeed(speed);
  Q_EMIT stateChanged();
}

/// Goes there; the follower stays where it is.
bool Playback::look(double fraction) {
  if (!start())
    return false;
  workspace_.guarded([&] { player_.seek(std::clamp(fraction, 0.0, 1.0)); });
  return true;
}

void Playback::lookAtSecond(double seconds) {
  const double period = player_.periodSeconds();
  if (period > 0 && look(std::fmod(seconds, period) / period))
    showPose();
}

void Playback::seek(double fraction) {
  if (!look(fraction))
    return;
  if (follower_)
    follower_->lookAtSecond(player_.secondsInCycle());
  showPose();
}

void Playback::step(int frames) {
  if (!sequence())
    return;
  pause();
  const double moved = player_.fraction() + frames * kStepSeconds / player_.periodSeconds();
  if (!look(moved - std::floor(moved)))
    return;
  if (follower_)
    follower_->step(frames);
  showPose();
}

void Playback::stop() {
  pause();
  if (follower_)
    follower_->stop();
  if (!started_)
    return;
  started_ = false;
  showWhatIsWanted();
  Q_EMIT stateChanged();
}

void Playback::showPose() {
  workspace_.guarded([this] {
    player_.pose(pose_);
    const auto& organs = workspace_.document().organs();
    const bool locked =
        std::any_of(organs.begin(), organs.end(), [](const auto& o) { return o->volumeLocked; });
    if (locked && !workspace_.live().busy())
      showKept();
    else
      workspace_.live().showPose(pose_);
  });
  Q_EMIT advanced();
}

/// The pose with locked volumes kept; where they cannot be kept, the last one in which they could stays.
void Playback::showKept() {
  const auto kept = keeper_.keep(pose_);
  if (kept.restored)
    workspace_.live().showPose(kept.pose);
  else if (!outOfReach_)
    workspace_.report(DataError("the locked volume cannot be kept here: " + kept.reason, sequence()->name(),
                                "unlock it, or let more handles compensate"));
  outOfReach_ = !kept.restored;
}

} // namespace viscera::app
