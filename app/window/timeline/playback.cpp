#include "window/timeline/playback.h"

#include <cmath>

#include "viscera/session/rig_commands.h"

namespace viscera::app {
namespace {
constexpr int kFrameMilliseconds = 16;
constexpr double kStepSeconds = 1.0 / 25.0;
} // namespace

Playback::Playback(Workspace& workspace, session::Player::Clock clock, QObject* parent)
    : QObject(parent), workspace_(workspace), player_(std::move(clock)) {
  frames_.setTimerType(Qt::PreciseTimer);
  frames_.setInterval(kFrameMilliseconds);
  connect(&frames_, &QTimer::timeout, this, &Playback::advance);
  subscription_ = workspace.onChange([this](const session::Change& change) {
    if (started_ && (change.rig() || !sequence()))
      stop();
    if (change.organs())
      Q_EMIT stateChanged();
  });
}

void Playback::setSequence(std::shared_ptr<const sequences::Sequence> sequence, session::OrganId organ) {
  stop();
  sequence_ = std::move(sequence);
  organ_ = organ;
  player_.setSequence(sequence_);
  Q_EMIT stateChanged();
}

const sequences::Sequence* Playback::sequence() const {
  return workspace_.document().organ(organ_) ? sequence_.get() : nullptr;
}

void Playback::advance() {
  if (player_.advance())
    showPose();
  if (!player_.playing())
    pause();
}

void Playback::setMode(Mode mode) {
  mode_ = mode;
  if (!follows())
    pause();
  showWhatModeWants();
}

void Playback::showWhatModeWants() {
  workspace_.guarded([this] {
    if (mode_ == Mode::handles)
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
    session::requireFits(workspace_.document().rig(), *sequence_);
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
  message.text = tr("%1 moves handles of its own, and these are others.").arg(text(sequence_->name()));
  message.offers.push_back(
      {tr("Use its handles"), [this] {
         if (workspace_.perform(session::replaceRig(session::rigOf(*sequence_),
                                                    tr("Use the sequence's handles").toStdString())))
           play();
       }});
  workspace_.say(message);
}

void Playback::play() {
  if (player_.playing() || !start())
    return;
  player_.play();
  frames_.start();
  showPose();
  Q_EMIT stateChanged();
}

void Playback::pause() {
  const bool was = frames_.isActive();
  player_.pause();
  frames_.stop();
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
  Q_EMIT stateChanged();
}

void Playback::seek(double fraction) {
  if (!start())
    return;
  workspace_.guarded([&] { player_.seek(std::clamp(fraction, 0.0, 1.0)); });
  showPose();
}

void Playback::step(int frames) {
  if (!sequence())
    return;
  pause();
  const double moved = player_.fraction() + frames * kStepSeconds / player_.periodSeconds();
  seek(moved - std::floor(moved));
}

void Playback::stop() {
  pause();
  if (!started_)
    return;
  started_ = false;
  showWhatModeWants();
  Q_EMIT stateChanged();
}

void Playback::showPose() {
  workspace_.guarded([this] {
    player_.pose(pose_);
    workspace_.live().showPose(pose_);
  });
  Q_EMIT advanced();
}

} // namespace viscera::app
