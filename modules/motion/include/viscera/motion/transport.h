#pragma once

#include <functional>
#include <vector>

#include "viscera/core/signal.h"

namespace viscera::motion {

class Player;

/// The pose that the views show: that of the document, the rest pose, or that of the sequence.
enum class WantedPose {
  document, ///< The document's own.
  rest,     ///< The handles at rest.
  sequence, ///< The sequence's once it was started, else the document's.
};

/// Keeps the time of playing sequences, for any number of views (`Player`), each with its own document,
/// sequence and rate: all are at the same seconds. The first view leads: its cycle is the one that is sought,
/// and ends where it does not loop. Whatever this is told, the views show it before the call returns; a
/// position is never moved without the pose. For one thread.
class Transport {
public:
  /// A clock in seconds that never goes back.
  using Clock = std::function<double()>;

  /// The steady clock of the machine.
  static Clock steadyClock();

  explicit Transport(Clock clock = steadyClock());
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;

  /// What follows calls `LiveBinding::showPose` of every view, and throws what one of them throws after all
  /// were asked.
  ///
  /// Starts; from the beginning when it had come to the end. Nothing happens while the first view has no
  /// sequence for its handles, or no sequence's pose is wanted.
  void play();
  /// Stays at the instant that is shown.
  void pause();
  /// The views go back to their documents' pose; the instant stays.
  void stop();
  /// Brings the views to where the clock is; true when they moved.
  bool advance();
  /// Looks at a place of the first view's cycle, [0, 1]; playing goes on from there. Throws `UsageError`
  /// outside. Nothing happens where `play` would do nothing.
  void seek(double fraction);
  /// Pauses, and goes on by some seconds of the sequence, or back.
  void step(double seconds);
  void setPose(WantedPose pose);
  WantedPose pose() const { return pose_; }

  bool playing() const { return playing_; }
  /// Whether a motion was started and not stopped since, be its pose wanted now or not.
  bool started() const { return started_; }
  /// Whether views with a sequence show its pose.
  bool showing() const { return started_ && pose_ == WantedPose::sequence; }

  bool isFirst(const Player& player) const { return !players_.empty() && players_.front() == &player; }

  /// Whether it begins again after a cycle (the standard) or stops at the end of it.
  void setLoop(bool loop);
  bool loop() const { return loop_; }
  /// How fast time passes: 0.25 is slow motion. Throws `UsageError` outside (0, 10].
  void setSpeed(double speed);
  double speed() const { return speed_; }
  /// Seconds of the sequence that have been played since it was set or sought: the chart's axis.
  double playedSeconds() const { return played_; }

  /// To be called after a document or a view's sequence has changed, once all who keep something of the
  /// document know of it. Where the first view's handles are no longer the sequence's, the motion is stopped
  /// at its beginning; else every view shows its instant again.
  void match();

  /// Tells that the views show another instant.
  [[nodiscard]] Subscription onShown(std::function<void()> observer) {
    return shown_.connect(std::move(observer));
  }
  /// Tells that it plays or not, of another sequence, rate, speed or loop, and of `match`.
  [[nodiscard]] Subscription onState(std::function<void()> observer) {
    return state_.connect(std::move(observer));
  }

private:
  friend class Player;

  bool ready() const;
  bool passTime();
  void show();
  void rewind();
  void placeOthers();

  Clock clock_;
  std::vector<Player*> players_; ///< The first one leads.
  Signal<> shown_;
  Signal<> state_;
  WantedPose pose_ = WantedPose::sequence;
  double speed_ = 1;
  double played_ = 0;
  double lastClock_ = 0;
  bool playing_ = false;
  bool started_ = false;
  bool loop_ = true;
};

} // namespace viscera::motion
