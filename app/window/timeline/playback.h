#pragma once

#include <QObject>
#include <QTimer>

#include <memory>
#include <string>
#include <vector>

#include "viscera/motion/player.h"
#include "viscera/sequences/heart_valves.h"
#include "window/workspace.h"

namespace viscera::app {

/// How fast time may pass: as it does, or in slow motion.
inline constexpr double kPlaybackSpeeds[] = {1, 0.5, 0.25, 0.1};

/// Plays the motions of a document's organs in a view: a transport's player with the frame timer, the signals
/// and the messages of a window. It knows the motions of several organs: undo brings an organ back with its
/// motion. What the document does to a motion is shown after everybody has heard of it, not from within the
/// document's notification.
class Playback final : public QObject {
  Q_OBJECT

public:
  /// A sequence and the organ that it moves.
  struct Motion {
    std::shared_ptr<const sequences::Sequence> sequence;
    document::OrganId organ;
    /// How to make the sequence again (motion_recipe.h); empty for one that the document itself holds.
    std::string recipe;
  };

  /// Has a transport of its own. `clock` in seconds; a test or a picture brings its own.
  Playback(Workspace& workspace, motion::Transport::Clock clock, QObject* parent = nullptr);
  /// Another view under the transport of `first`.
  Playback(Workspace& workspace, Playback& first, QObject* parent = nullptr);

  /// Takes a sequence and the organ that it belongs to, and makes it the present one; it is offered while
  /// that organ is in the document. Null: none is present.
  void setSequence(std::shared_ptr<const sequences::Sequence> sequence, document::OrganId organ,
                   std::string recipe = {});
  /// Takes a sequence to choose from, and leaves the present one.
  void offer(std::shared_ptr<const sequences::Sequence> sequence, document::OrganId organ,
             std::string recipe = {});
  /// Puts another sequence of the same handles in the place of one that was set or offered; when it is the
  /// present one, the instant stays, and whether it plays. Nothing happens when `known` is not known.
  void exchange(const sequences::Sequence* known, std::shared_ptr<const sequences::Sequence> sequence);
  /// Takes back a sequence that was set or offered.
  void forget(const sequences::Sequence* sequence);
  /// Takes back all of them: another document has organs of its own.
  void forgetAll();
  /// The motions for the organs there are, the oldest first.
  std::vector<Motion> motions() const;
  /// Makes one of `motions` the present one, stopped at its beginning.
  void choose(const sequences::Sequence* sequence);
  /// The sequence that can be played; null when there is none for the organs there are.
  const sequences::Sequence* sequence() const { return player_.sequence(); }
  /// The same with the organ that it moves; both are empty when there is none.
  Motion motion() const { return sequence() ? present_ : Motion{}; }
  /// The present one, for a worker that needs it longer; null when there is none.
  std::shared_ptr<const sequences::Sequence> sharedSequence() const { return motion().sequence; }
  const motion::Player& player() const { return player_; }
  /// The valves of the heart that is shown beating; nothing when none is.
  std::optional<sequences::ValveInstants> valves() const;
  /// Whether the organs show the sequence's pose.
  bool showing() const { return player_.showing(); }

  /// Which pose the mode wants to be shown.
  motion::WantedPose wantedPose() const { return transport_->pose(); }
  /// Which pose is wanted; a sequence that plays is paused when it is not its own.
  void setPose(motion::WantedPose pose) {
    changeTransport([&] { transport_->setPose(pose); });
  }
  /// Prescribes the volume of an organ while the present sequence moves it; none takes it back. False, with a
  /// message, where it cannot be reached.
  bool prescribe(const std::optional<motion::PrescribedVolume>& volume) {
    return changeTransport([&] { player_.prescribe(volume); });
  }

public Q_SLOTS:
  /// Brings the organs of all views to where the clock is; the frame timer calls it while playing.
  void advance() {
    changeTransport([this] { transport_->advance(); });
  }
  void play();
  void pause() {
    changeTransport([this] { transport_->pause(); });
  }
  void toggle() { transport_->playing() ? pause() : play(); }
  void setLooping(bool looping) {
    changeTransport([&] { transport_->setLoop(looping); });
  }
  void setRate(double perMinute);
  void setSpeed(double speed);
  /// Looks at a place of the cycle, [0, 1].
  void seek(double fraction);
  /// Steps by frames of a twenty-fifth of a second.
  void step(int frames);
  /// Steps by the smallest time that shows something new of this sequence (10 ms of a heart), else by frames.
  void stepFinely(int steps);
  void toStart() { seek(0); }
  /// The organs go back to the document's pose.
  void stop() {
    changeTransport([this] { transport_->stop(); });
  }

Q_SIGNALS:
  /// Another sequence, playing or not, rate, loop.
  void stateChanged();
  /// The organs of all views are in another instant of their sequences.
  void advanced();
  /// Playing needs a mode in which the sequence's pose is shown.
  void playModeWanted();

private:
  Playback(Workspace& workspace, std::shared_ptr<motion::Transport> transport, QObject* parent);
  void remember(const Motion& motion);
  void take(const Motion& motion);
  void takeMatchingMotion();
  void showLater();
  void showChanges();
  /// Does something with the transport, after what the document did; an error becomes a message.
  bool changeTransport(const std::function<void()>& what);
  bool start();
  void offerOwnHandles();
  void onShown();
  void onState();

  Workspace& workspace_;
  std::shared_ptr<motion::Transport> transport_;
  motion::Player player_;
  std::vector<Motion> known_; ///< Also those whose organ is gone: undo may bring it back.
  Motion present_;
  bool showPending_ = false; ///< The document or the sequence has changed, and nothing was shown yet.
  QString otherHandles_;     ///< What was said of handles that are not the sequence's.
  bool outOfReach_ = false;  ///< It was said that a locked volume cannot be kept.
  QTimer frames_;            ///< Runs in the first view.
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
