#pragma once

#include <QObject>
#include <QTimer>

#include <memory>
#include <string>
#include <vector>

#include "viscera/live/volume_keeper.h"
#include "viscera/motion/player.h"
#include "window/workspace.h"

namespace viscera::app {

/// Which pose a mode wants to be shown.
enum class WantedPose {
  rest,     ///< The handles at rest.
  document, ///< The document's.
  sequence  ///< The sequence's once it has been started, else the document's.
};

/// Plays a sequence on the organs, frame by frame, without touching the document; and decides which pose is
/// shown, of those that the mode wants.
/// It knows the motions of several organs: undo brings an organ back with its motion.
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

  /// `clock` in seconds; a test or a picture brings its own.
  Playback(Workspace& workspace, motion::Player::Clock clock, QObject* parent = nullptr);

  /// Takes a sequence and the organ that it belongs to, and makes it the present one; it is offered while
  /// that organ is in the document. Null: none is present.
  void setSequence(std::shared_ptr<const sequences::Sequence> sequence, document::OrganId organ,
                   std::string recipe = {});
  /// Takes a sequence to choose from, and leaves the present one.
  void offer(std::shared_ptr<const sequences::Sequence> sequence, document::OrganId organ,
             std::string recipe = {});
  /// Takes back a sequence that was set or offered.
  void forget(const sequences::Sequence* sequence);
  /// Takes back all of them: another document has organs of its own.
  void forgetAll();
  /// The motions for the organs there are, the oldest first.
  std::vector<Motion> motions() const;
  /// Makes one of `motions` the present one, stopped at its beginning.
  void choose(const sequences::Sequence* sequence);
  /// The sequence that can be played; null when there is none for the organs there are.
  const sequences::Sequence* sequence() const;
  /// The same with the organ that it moves; both are empty when there is none.
  Motion motion() const { return sequence() ? present_ : Motion{}; }
  /// The present one, for a worker that needs it longer; null when there is none.
  std::shared_ptr<const sequences::Sequence> sharedSequence() const { return motion().sequence; }
  const motion::Player& player() const { return player_; }
  /// Whether the organs show the sequence's pose.
  bool showing() const { return started_ && follows(); }

  void setPose(WantedPose wanted);

  /// Another playback that does what this one does, at the same seconds and at a rate of its own, for organs
  /// beside these; null: none. It has to live until another one is set.
  void setFollower(Playback* follower);

public Q_SLOTS:
  /// Brings the organs to where the clock is; the frame timer calls it while playing.
  void advance();
  void play();
  void pause();
  void toggle();
  void setLooping(bool looping);
  void setRate(double perMinute);
  void setSpeed(double speed);
  /// Looks at a place of the cycle, [0, 1].
  void seek(double fraction);
  /// Steps by frames of a twenty-fifth of a second.
  void step(int frames);
  void toStart() { seek(0); }
  /// The organs go back to the document's pose.
  void stop();

Q_SIGNALS:
  /// Another sequence, playing or not, rate, loop.
  void stateChanged();
  /// The organs are in another instant of the sequence; the follower's, too.
  void advanced();
  /// Playing needs a mode in which the sequence's pose is shown.
  void playModeWanted();

private:
  bool follows() const { return wanted_ == WantedPose::sequence; }
  void remember(const Motion& motion);
  void take(const Motion& motion);
  void takeWhatFits();
  bool start();
  bool look(double fraction);
  void lookAtSecond(double seconds);
  void showPose();
  void showKept();
  void showWhatIsWanted();
  void offerOwnHandles();

  Workspace& workspace_;
  motion::Player player_;
  std::vector<Motion> known_; ///< Also those whose organ is gone: undo may bring it back.
  Motion present_;
  live::VolumeKeeper keeper_;
  bool outOfReach_ = false; ///< It was said that a locked volume cannot be kept.
  WantedPose wanted_ = WantedPose::sequence;
  bool started_ = false;
  bool driven_ = false; ///< It is a follower: another playback says when the time goes on.
  Playback* follower_ = nullptr;
  Points pose_;
  QTimer frames_;
  Subscription subscription_;
};

} // namespace viscera::app
