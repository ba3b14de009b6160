#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/core/signal.h"
#include "viscera/live/live_binding.h"
#include "viscera/live/motion_runner.h"

namespace viscera::live {

/// The pose that the views show: that of the document, the rest pose, or that of the sequence.
enum class WantedPose {
  document, ///< The document's own.
  rest,     ///< The handles at rest.
  sequence, ///< The sequence's once it was started, else the document's.
};

/// Plays a sequence in a view, by a clock. Further players may join the first one: each has its own document,
/// sequence and rate, and all have one time, so that they show the same second. The first player leads:
/// seeking refers to its cycle, and without looping playback stops at the end of its cycle.
///
/// A player shows poses without touching the document, so that playing leaves no undo steps. It keeps its
/// place in cycles: another rate goes on from the same place of the cycle. Every call updates the poses of
/// all views before it returns, so that place and pose always agree. For the document's thread.
///
///     Player player(document.state(), live);
///     player.setSequence(sequence, organ);
///     player.play();
///     player.advance(); // With every frame.
class Player {
public:
  /// A clock in seconds that never goes back.
  using Clock = std::function<double()>;

  /// The steady clock of the machine.
  static Clock steadyClock();

  /// The first player. All must live longer; `state` is the document's own. `jobs` as for `MotionRunner`.
  Player(const document::DocumentState& state, LiveBinding& live, Clock clock = steadyClock(),
         JobQueue* jobs = nullptr);
  /// Joins another player, in whose time it plays. If the first one goes, the next one leads.
  Player(Player& joined, const document::DocumentState& state, LiveBinding& live, JobQueue* jobs = nullptr);
  ~Player();
  Player(const Player&) = delete;
  Player& operator=(const Player&) = delete;

  /// This view's sequence.
  ///
  /// Sets the sequence of an organ (or none), at its standard rate; `match` shows it. In the first view the
  /// motion is stopped at its beginning; another view goes to the first one's instant.
  void setSequence(std::shared_ptr<const sequences::Sequence> sequence, document::OrganId organ);
  /// Replaces the sequence by another one of the same handles, at its standard rate. The place in the cycle,
  /// playing, and the prescribed volume stay. `match` shows it.
  void exchangeSequence(std::shared_ptr<const sequences::Sequence> sequence);
  /// Null while there is none, and while its organ is not in the document.
  const sequences::Sequence* sequence() const;
  /// Whether there is a sequence and the handles are its own. O(handles).
  bool movable() const { return sequence() && runner_.movable(); }
  /// Whether the organs are in the sequence's pose.
  bool showing() const;
  /// Cycles a minute. Throws `UsageError` outside what the sequence allows.
  void setRatePerMinute(double rate);
  double ratePerMinute() const { return runner_.ratePerMinute(); }
  double periodSeconds() const { return runner_.periodSeconds(); }
  /// Prescribes the volume of an organ, or none, and shows it. Throws `DataError` that names the instant at
  /// which it cannot be reached, and then changes nothing.
  void prescribe(const std::optional<PrescribedVolume>& volume);
  const MotionRunner& runner() const { return runner_; }
  /// The place in the cycle, [0, 1); 1 at the end of one that does not loop.
  double fraction() const { return fraction_; }
  /// Seconds since the beginning of the cycle at the present rate.
  double secondsInCycle() const { return fraction_ * periodSeconds(); }
  /// The name of the phase that the place lies in; empty when there is none.
  Text phase() const;
  /// Whether time passes and there is a sequence.
  bool playing() const { return running() && sequence(); }

  /// The time of all views. A function that poses them calls every view, also when one throws; then the
  /// exception is rethrown.
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
  WantedPose pose() const { return time_->pose; }
  /// Whether it begins again after a cycle (the standard) or stops at the end of it.
  void setLoop(bool loop);
  bool loop() const { return time_->loop; }
  /// How fast time passes: 0.25 is slow motion. Throws `UsageError` outside (0, 10].
  void setSpeed(double speed);
  double speed() const { return time_->speed; }
  /// Seconds of the sequence that have been played since it was set or sought: the chart's axis.
  double playedSeconds() const { return time_->played; }
  bool running() const { return time_->running; } ///< Whether time passes.
  /// Whether a motion was started and not stopped since, whether its pose is shown or not.
  bool started() const { return time_->started; }
  bool leads() const { return time_->players.front() == this; } ///< Whether it is the first one.

  /// Call it after a document or a view's sequence has changed and all objects derived from the document are
  /// up to date. If the first view's handles are no longer the sequence's, the motion is stopped at its
  /// beginning; else every view shows its instant again.
  void match();

  /// Calls `observer` when the views show another instant.
  [[nodiscard]] Subscription onShown(std::function<void()> observer) {
    return time_->shown.connect(std::move(observer));
  }
  /// Calls `observer` when playing, sequence, rate, speed or loop have changed, and after `match`.
  [[nodiscard]] Subscription onState(std::function<void()> observer) {
    return time_->state.connect(std::move(observer));
  }

private:
  /// What all views have in common.
  struct Time {
    Clock clock;
    std::vector<Player*> players = {}; ///< The first one leads.
    Signal<> shown = {};
    Signal<> state = {};
    WantedPose pose = WantedPose::sequence;
    double speed = 1;
    double played = 0;
    double lastClock = 0;
    bool running = false;
    bool started = false;
    bool loop = true;
  };

  Player& first() const { return *time_->players.front(); }
  bool ready() const;
  bool passTime();
  void pass(double seconds);
  void rewind();
  void placeOthers();
  void showAll();
  void showOwn();

  std::shared_ptr<Time> time_;
  const document::DocumentState& state_;
  LiveBinding& live_;
  MotionRunner runner_;
  document::OrganId organ_;
  double fraction_ = 0;
};

} // namespace viscera::live
