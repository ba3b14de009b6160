#pragma once

#include <functional>
#include <memory>
#include <string>

#include "viscera/document/rig.h"
#include "viscera/document/rig_commands.h"
#include "viscera/sequences/sequence.h"

namespace viscera::motion {

/// Plays a sequence: says which pose belongs to this moment. It changes nothing itself; whoever draws a frame
/// calls `advance` and hands `pose` to `LiveBinding::showPose`, so that playing leaves no undo steps. The
/// position is kept in cycles: another rate goes on from the same place of the cycle. For one thread.
class Player {
public:
  /// A clock in seconds that never goes back.
  using Clock = std::function<double()>;

  /// The steady clock of the machine.
  static Clock steadyClock();

  explicit Player(Clock clock = steadyClock());

  /// Takes another sequence (or none): stopped, at its beginning, at its standard rate.
  void setSequence(std::shared_ptr<const sequences::Sequence> sequence);
  const sequences::Sequence* sequence() const { return sequence_.get(); }

  /// Starts; from the beginning when it had come to the end. Nothing happens without a sequence.
  void play();
  void pause();
  bool playing() const { return playing_; }

  /// Whether it begins again after a cycle (the standard) or stops at the end of it.
  void setLoop(bool loop) { loop_ = loop; }
  bool loop() const { return loop_; }
  /// Cycles a minute. Throws `UsageError` outside what the sequence allows.
  void setRatePerMinute(double rate);
  double ratePerMinute() const { return rate_; }
  /// How fast time passes: 0.25 is slow motion. Throws `UsageError` outside (0, 10].
  void setSpeed(double speed);
  double speed() const { return speed_; }

  /// Goes to a place of the cycle, [0, 1]; playing goes on from there. Throws `UsageError` outside.
  void seek(double fraction);

  /// Brings the position up to the clock; true when it moved.
  bool advance();

  /// The place in the cycle, [0, 1); 1 at the end of one that does not loop.
  double fraction() const { return fraction_; }
  /// Seconds since the beginning of the cycle at the present rate.
  double secondsInCycle() const;
  double periodSeconds() const { return rate_ > 0 ? 60.0 / rate_ : 0; }
  /// Seconds of the sequence that have been played since it was set or sought: the chart's axis.
  double playedSeconds() const { return played_; }
  /// The name of the phase that the position lies in; empty when there is none.
  std::string phase() const;

  /// Fills `pose` (`n x 3`) for the present position. Depends on nothing but position and rate. Needs a
  /// sequence.
  void pose(Points& pose) const;

private:
  Clock clock_;
  std::shared_ptr<const sequences::Sequence> sequence_;
  double rate_ = 0;
  double speed_ = 1;
  double fraction_ = 0;
  double played_ = 0;
  double lastClock_ = 0;
  bool playing_ = false;
  bool loop_ = true;
};

} // namespace viscera::motion
