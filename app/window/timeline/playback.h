#pragma once

#include <QObject>
#include <QTimer>

#include <memory>

#include "viscera/session/player.h"
#include "window/mode.h"
#include "window/workspace.h"

namespace viscera::app {

/// Plays a sequence on the organs, frame by frame, without touching the document; and decides which pose is
/// shown: rest in Handles mode, the document's in Deform mode, else the sequence's once it has been started.
class Playback final : public QObject {
  Q_OBJECT

public:
  /// `clock` in seconds; a test or a picture brings its own.
  Playback(Workspace& workspace, session::Player::Clock clock, QObject* parent = nullptr);

  /// Takes a sequence and the organ that it belongs to; it is offered while that organ is in the document.
  void setSequence(std::shared_ptr<const sequences::Sequence> sequence, session::OrganId organ);
  /// The sequence that can be played; null when there is none for the organs there are.
  const sequences::Sequence* sequence() const;
  /// The same, for a worker that needs it longer.
  std::shared_ptr<const sequences::Sequence> sharedSequence() const {
    return sequence() ? sequence_ : nullptr;
  }
  const session::Player& player() const { return player_; }
  /// Whether the organs show the sequence's pose.
  bool showing() const { return started_ && follows(); }

  void setMode(Mode mode);

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
  /// The organs are in another instant of the sequence.
  void advanced();
  /// Playing needs a mode in which the sequence's pose is shown.
  void playModeWanted();

private:
  bool follows() const { return mode_ == Mode::explore || mode_ == Mode::stress || mode_ == Mode::play; }
  bool start();
  void showPose();
  void showWhatModeWants();
  void offerOwnHandles();

  Workspace& workspace_;
  session::Player player_;
  std::shared_ptr<const sequences::Sequence> sequence_;
  session::OrganId organ_;
  Mode mode_ = Mode::explore;
  bool started_ = false;
  Points pose_;
  QTimer frames_;
  session::Subscription subscription_;
};

} // namespace viscera::app
