#include "window/timeline/playback.h"

#include <algorithm>
#include <utility>

#include "viscera/core/phrase.h"
#include "viscera/document/rig_commands.h"
#include "viscera/heart/beating_heart.h"
#include "window/style/language.h"

namespace viscera::app {
namespace {

constexpr int kFrameMilliseconds = 16;
constexpr double kStepSeconds = 1.0 / 25.0;
/// A motion holds coordinates of its organ: tens of megabytes.
constexpr std::size_t kMostMotions = 8;

bool anyLocked(const document::OrganList& organs) {
  return std::any_of(organs.begin(), organs.end(), [](const auto& organ) { return organ->volumeLocked; });
}

} // namespace

Playback::Playback(Workspace& workspace, live::Player::Clock clock, QObject* parent)
    : QObject(parent), workspace_(workspace),
      player_(workspace.state(), workspace.live(), std::move(clock), &workspace.jobs()) {
  watch();
}

Playback::Playback(Workspace& workspace, Playback& first, QObject* parent)
    : QObject(parent), workspace_(workspace),
      player_(first.player_, workspace.state(), workspace.live(), &workspace.jobs()) {
  watch();
}

void Playback::watch() {
  frames_.setTimerType(Qt::PreciseTimer);
  frames_.setInterval(kFrameMilliseconds);
  connect(&frames_, &QTimer::timeout, this, &Playback::advance);
  subscriptions_.push_back(player_.onShown([this] { onShown(); }));
  subscriptions_.push_back(player_.onState([this] { onState(); }));
  subscriptions_.push_back(workspace_.onChange([this](const document::Change& change) {
    // Locked volumes are those of the own pose, so that an instant is another one when that is reset.
    const bool otherVolumes = change.pose() && showing() && anyLocked(workspace_.document().organs());
    if (change.organs() || otherVolumes || (change.rig() && player_.started())) {
      showPending_ = true;
      workspace_.afterChange([this] { showChanges(); });
    }
    if (change.pose() && document::atRest(change.before) != document::atRest(change.after))
      workspace_.afterChange([this] { Q_EMIT stillPoseChanged(); });
    if (!sequence() || player_.movable())
      retractOffer();
  }));
  // Locked volumes are kept by the new coordinates, and not at all while an organ is still being bound.
  subscriptions_.push_back(workspace_.live().onEvent([this](const live::LiveEvent& event) {
    if (event.status && showing() && !workspace_.live().busy())
      showLater();
  }));
}

void Playback::setSequence(std::shared_ptr<const sequences::Sequence> sequence, document::OrganId organ,
                           live::MotionRecipe recipe) {
  const Motion motion{std::move(sequence), organ, std::move(recipe)};
  remember(motion);
  take(motion);
}

void Playback::offer(std::shared_ptr<const sequences::Sequence> sequence, document::OrganId organ,
                     live::MotionRecipe recipe) {
  remember({std::move(sequence), organ, std::move(recipe)});
  showLater();
}

void Playback::remember(const Motion& motion) {
  if (!motion.sequence)
    return;
  if (known_.size() >= kMostMotions)
    known_.erase(known_.begin());
  known_.push_back(motion);
}

void Playback::exchange(const sequences::Sequence* known,
                        std::shared_ptr<const sequences::Sequence> sequence) {
  const auto isIt = [known](const Motion& motion) { return motion.sequence.get() == known; };
  const auto found = std::find_if(known_.begin(), known_.end(), isIt);
  if (found == known_.end())
    return;
  const bool present = isIt(present_);
  found->sequence = std::move(sequence);
  if (present) {
    present_ = *found;
    player_.exchangeSequence(present_.sequence);
  }
  changePlayer([this] { player_.match(); });
}

void Playback::forget(const sequences::Sequence* sequence) {
  std::erase_if(known_, [sequence](const Motion& motion) { return motion.sequence.get() == sequence; });
  if (present_.sequence.get() != sequence)
    return;
  take({});
  takeMatchingMotion();
}

void Playback::forgetAll() {
  known_.clear();
  take({});
}

std::vector<Playback::Motion> Playback::motions() const {
  std::vector<Motion> there;
  for (const Motion& motion : known_)
    if (workspace_.document().organ(motion.organ))
      there.push_back(motion);
  return there;
}

void Playback::choose(const sequences::Sequence* sequence) {
  for (const Motion& motion : motions())
    if (motion.sequence.get() == sequence && present_.sequence != motion.sequence)
      take(motion);
  showChanges();
}

void Playback::take(const Motion& motion) {
  retractOffer();
  present_ = motion;
  player_.setSequence(present_.sequence, present_.organ);
  showLater();
}

/// Organs came or went: the youngest motion whose organ is there, unless the present one's still is.
void Playback::takeMatchingMotion() {
  if (sequence())
    return;
  const std::vector<Motion> there = motions();
  if (!there.empty())
    take(there.back());
}

/// The parts of the window are notified of a change one after the other, so the view is updated after all of
/// them.
void Playback::showLater() {
  if (!std::exchange(showPending_, true))
    QMetaObject::invokeMethod(this, &Playback::showChanges, Qt::QueuedConnection);
}

void Playback::showChanges() {
  if (!showPending_)
    return;
  takeMatchingMotion();
  showPending_ = false;
  workspace_.guarded([this] { player_.match(); });
}

bool Playback::changePlayer(const std::function<void()>& what) {
  showChanges();
  return workspace_.guarded(what);
}

/// Whether there is a sequence to show; requests a mode that shows it.
bool Playback::start() {
  showChanges();
  if (!sequence())
    return false;
  if (!player_.movable()) {
    offerOwnHandles();
    return false;
  }
  if (player_.pose() != live::WantedPose::sequence)
    Q_EMIT playModeWanted();
  return player_.pose() == live::WantedPose::sequence;
}

void Playback::offerOwnHandles() {
  Message message;
  message.severity = Message::Severity::warning;
  message.text = tr("The sequence %1 moves its own handles, but the document has others.")
                     .arg(inWords(present_.sequence->name()));
  message.offers.push_back(
      {tr("Use its handles"), [this] {
         if (workspace_.perform(document::replaceRig(document::rigOf(*present_.sequence),
                                                     tr("Use the sequence's handles").toStdString())))
           play();
       }});
  otherHandles_ = message.text;
  workspace_.say(message);
}

/// The offer names the present sequence.
void Playback::retractOffer() {
  if (!otherHandles_.isEmpty())
    workspace_.retract(std::exchange(otherHandles_, {}));
}

void Playback::play() {
  if (!player_.running() && start())
    changePlayer([this] { player_.play(); });
}

void Playback::setRate(double perMinute) {
  if (!changePlayer([&] { player_.setRatePerMinute(perMinute); }))
    Q_EMIT stateChanged(); // Resets the control to the actual rate.
}

void Playback::setSpeed(double speed) {
  if (!changePlayer([&] { player_.setSpeed(speed); }))
    Q_EMIT stateChanged();
}

std::optional<heart::ValveInstants> Playback::valves() const {
  if (!showing())
    return std::nullopt;
  return heart::valvesAt(*sequence(), player_.secondsInCycle(), player_.ratePerMinute());
}

std::optional<heart::BeatClock> Playback::clock() const {
  if (!showing())
    return std::nullopt;
  return heart::clockAt(*sequence(), player_.secondsInCycle(), player_.ratePerMinute());
}

QString Playback::stillPose() const {
  return document::atRest(workspace_.state()) ? tr("at rest") : tr("posed by hand");
}

void Playback::seek(double fraction) {
  if (start())
    changePlayer([&] { player_.seek(std::clamp(fraction, 0.0, 1.0)); });
}

void Playback::setPlace(double fraction) {
  changePlayer([&] { player_.setPlace(std::clamp(fraction, 0.0, 1.0)); });
}

void Playback::step(int frames) {
  pause();
  if (start())
    changePlayer([&] { player_.step(frames * kStepSeconds); });
}

void Playback::stepFinely(int steps) {
  const double finest = sequence() ? sequence()->finestStepSeconds() : 0;
  pause();
  if (start())
    changePlayer([&] { player_.step(steps * (finest > 0 ? finest : kStepSeconds)); });
}

void Playback::onShown() {
  const Text& obstacle = player_.runner().obstacle();
  const bool outOfReach = !obstacle.empty() && !workspace_.live().busy();
  if (outOfReach && !outOfReach_)
    workspace_.report(DataError(phrase("the volume cannot be kept here: %1", obstacle),
                                present_.sequence->name(), "unlock it, or let more handles compensate"));
  outOfReach_ = outOfReach;
  Q_EMIT advanced();
}

/// The first view's timer makes the frames of all.
void Playback::onState() {
  if (player_.running() && player_.leads())
    frames_.start();
  else
    frames_.stop();
  Q_EMIT stateChanged();
}

} // namespace viscera::app
