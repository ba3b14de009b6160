#pragma once

#include <QObject>
#include <QTimer>

#include <memory>
#include <string>
#include <vector>

#include "viscera/heart/beating_heart.h"
#include "viscera/heart/heart_valves.h"
#include "viscera/live/motion_recipe.h"
#include "viscera/live/player.h"
#include "window/work/workspace.h"

namespace viscera::app {

/// The speeds of playback: real time and slow motion.
inline constexpr double kPlaybackSpeeds[] = {1, 0.5, 0.25, 0.1};

/// Plays the motions of a document's organs in a view: a player with the frame timer, the signals and the
/// messages of a window. It remembers the motions of several organs, so that undo restores an organ
/// with its motion. When a change of the document affects a motion, the view is updated after all observers
/// were notified, not within the document's notification.
class Playback final : public QObject {
  Q_OBJECT

public:
  /// A sequence and the organ that it moves.
  struct Motion {
    std::shared_ptr<const sequences::Sequence> sequence;
    document::OrganId organ;
    /// Makes the sequence again; nothing is known for one that the document itself holds.
    live::MotionRecipe recipe;
  };

  /// Serves the first view. `clock` returns seconds; tests and pictures pass a clock of their own.
  Playback(Workspace& workspace, live::Player::Clock clock, QObject* parent = nullptr);
  /// Serves another view, in the time of `first`.
  Playback(Workspace& workspace, Playback& first, QObject* parent = nullptr);

  /// Adds a sequence for an organ and makes it the present one; `motions` lists it while that organ is in the
  /// document. Null: no sequence is present.
  void setSequence(std::shared_ptr<const sequences::Sequence> sequence, document::OrganId organ,
                   live::MotionRecipe recipe = {});
  /// Adds a sequence to `motions` and keeps the present one.
  void offer(std::shared_ptr<const sequences::Sequence> sequence, document::OrganId organ,
             live::MotionRecipe recipe = {});
  /// Replaces a sequence that was set or offered by another one of the same handles; if it is the present
  /// one, the instant stays, and playing goes on. Nothing happens when `known` is not known.
  void exchange(const sequences::Sequence* known, std::shared_ptr<const sequences::Sequence> sequence);
  /// Removes a sequence that was set or offered.
  void forget(const sequences::Sequence* sequence);
  /// Removes all of them, when another document is opened.
  void forgetAll();
  /// The motions of the present organs, the oldest first.
  std::vector<Motion> motions() const;
  /// Makes one of `motions` the present one, stopped at its beginning.
  void choose(const sequences::Sequence* sequence);
  /// The sequence that can be played; null when there is none for the present organs.
  const sequences::Sequence* sequence() const { return player_.sequence(); }
  /// The same with the organ that it moves; both are empty when there is none.
  Motion motion() const { return sequence() ? present_ : Motion{}; }
  /// The same with shared ownership, for a worker; null when there is none.
  std::shared_ptr<const sequences::Sequence> sharedSequence() const { return motion().sequence; }
  const live::Player& player() const { return player_; }
  /// The valves of the heart that is shown beating; nothing when none is.
  std::optional<heart::ValveInstants> valves() const;
  /// The instant of the beat of the heart that is shown beating; nothing when none is.
  std::optional<heart::BeatClock> clock() const;
  /// Whether the organs show the sequence's pose.
  bool showing() const { return player_.showing(); }
  /// What the organs show while they do not show the sequence: the rest pose, or one that a hand made.
  QString stillPose() const;

  /// The pose that the mode wants to show.
  live::WantedPose wantedPose() const { return player_.pose(); }
  /// Sets the pose to show; pauses the sequence unless its own pose is to be shown.
  void setPose(live::WantedPose pose) {
    changePlayer([&] { player_.setPose(pose); });
  }
  /// Prescribes the volume of an organ while the present sequence moves it; none: no volume is prescribed.
  /// Returns false and shows a message if the volume cannot be reached.
  bool prescribe(const std::optional<live::PrescribedVolume>& volume) {
    return changePlayer([&] { player_.prescribe(volume); });
  }

public Q_SLOTS:
  /// Poses the organs of all views at the time of the clock; the frame timer calls it while playing.
  void advance() {
    changePlayer([this] { player_.advance(); });
  }
  void play();
  void pause() {
    changePlayer([this] { player_.pause(); });
  }
  void toggle() { player_.running() ? pause() : play(); }
  void setLooping(bool looping) {
    changePlayer([&] { player_.setLoop(looping); });
  }
  void setRate(double perMinute);
  void setSpeed(double speed);
  /// Goes to an instant of the cycle, [0, 1].
  void seek(double fraction);
  /// The same, without a request for a mode that shows it: for a session that was saved in another one.
  void setPlace(double fraction);
  /// Steps by frames of a twenty-fifth of a second.
  void step(int frames);
  /// Steps by the smallest useful time of this sequence (10 ms for a heart), or by frames if it has none.
  void stepFinely(int steps);
  void toStart() { seek(0); }
  /// Stops, and shows the document's pose.
  void stop() {
    changePlayer([this] { player_.stop(); });
  }

Q_SIGNALS:
  /// The sequence, whether it plays, its rate or looping has changed.
  void stateChanged();
  /// The organs of all views were posed at another instant of their sequences.
  void advanced();
  /// The organs at rest were posed by hand, or went back to rest.
  void stillPoseChanged();
  /// Emitted when playing needs a mode that shows the sequence's pose.
  void playModeWanted();

private:
  void watch();
  void remember(const Motion& motion);
  void take(const Motion& motion);
  void takeMatchingMotion();
  void showLater();
  void showChanges();
  /// Calls `what`, which changes the player, after pending changes of the document; an error is shown as a
  /// message.
  bool changePlayer(const std::function<void()>& what);
  bool start();
  void offerOwnHandles();
  void retractOffer();
  void onShown();
  void onState();

  Workspace& workspace_;
  live::Player player_;
  std::vector<Motion> known_; ///< Includes motions of removed organs, which undo may restore.
  Motion present_;
  bool showPending_ = false; ///< The document or the sequence has changed, and the view was not updated yet.
  QString otherHandles_;     ///< The message shown about handles that are not the sequence's.
  bool outOfReach_ = false;  ///< A message was shown that a locked volume cannot be kept.
  QTimer frames_;            ///< Runs in the first view.
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
