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

/// Keeps the common time of sequences played in any number of views (`Player`), each with its own document,
/// sequence and rate. The first view leads: seeking refers to its cycle, and without looping playback stops
/// at the end of its cycle. Every call updates the poses of the views before it returns, so position and pose
/// always agree. For one thread.
class Transport {
public:
  /// A clock in seconds that never goes back.
  using Clock = std::function<double()>;

  /// The steady clock of the machine.
  static Clock steadyClock();

  explicit Transport(Clock clock = steadyClock());
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;

  /// The functions below call `LiveBinding::showPose` of every view; if one throws, the others are still
  /// called before the exception is rethrown.
  ///
  /// Starts playing, from the beginning if it had come to the end. Nothing happens while the first view has
  /// no sequence for its handles, or while the wanted pose is not the sequence's.
  void play();
  /// Pauses at the displayed instant.
  void pause();
  /// Shows the documents' poses again; the instant stays.
  void stop();
  /// Poses the views at the time of the clock; returns whether they moved.
  bool advance();
  /// Goes to a place of the first view's cycle, [0, 1]; playing goes on from there. Throws `UsageError`
  /// outside. Nothing happens if `play` would do nothing.
  void seek(double fraction);
  /// The same, also while another pose is wanted: the place is shown when the sequence's is wanted again.
  void setPlace(double fraction);
  /// Pauses, and moves by some seconds of the sequence, forward or back.
  void step(double seconds);
  void setPose(WantedPose pose);
  WantedPose pose() const { return pose_; }

  bool playing() const { return playing_; }
  /// Whether a motion was started and not stopped since, whether its pose is shown or not.
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

  /// Call it after a document or a view's sequence has changed and all objects derived from the document are
  /// up to date. If the first view's handles are no longer the sequence's, the motion is stopped at its
  /// beginning; else every view shows its instant again.
  void match();

  /// Calls `observer` when the views show another instant.
  [[nodiscard]] Subscription onShown(std::function<void()> observer) {
    return shown_.connect(std::move(observer));
  }
  /// Calls `observer` when playing, sequence, rate, speed or loop have changed, and after `match`.
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
