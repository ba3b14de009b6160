#pragma once

#include <memory>
#include <string>

#include "viscera/live/live_binding.h"
#include "viscera/motion/motion_runner.h"
#include "viscera/motion/transport.h"

namespace viscera::motion {

/// Plays a sequence in one view of a `Transport`: it holds the sequence of the organs, its rate, and the
/// position in the cycle. It shows poses without touching the document, so playing leaves no undo steps. The
/// position is kept in cycles: another rate goes on from the same place of the cycle. For the document's
/// thread.
class Player {
public:
  /// Adds the view to `transport`; the first view leads. All must live longer; `state` is the document's own.
  /// `jobs` as for `MotionRunner`.
  Player(Transport& transport, const document::DocumentState& state, live::LiveBinding& live,
         JobQueue* jobs = nullptr);
  ~Player();
  Player(const Player&) = delete;
  Player& operator=(const Player&) = delete;

  /// Sets the sequence of an organ (or none), at its standard rate; `Transport::match` shows it. In the first
  /// view the motion is stopped at its beginning; other views go to the first one's instant.
  void setSequence(std::shared_ptr<const sequences::Sequence> sequence, document::OrganId organ);
  /// Replaces the sequence by another one of the same handles, at its standard rate. The position in the
  /// cycle, playing, and the prescribed volume stay. `Transport::match` shows it.
  void exchangeSequence(std::shared_ptr<const sequences::Sequence> sequence);
  /// Null while there is none, and while its organ is not in the document.
  const sequences::Sequence* sequence() const;
  /// Whether there is a sequence and the handles are its own. O(handles).
  bool movable() const { return sequence() && runner_.movable(); }
  /// Whether the organs are in the sequence's pose.
  bool showing() const { return transport_.showing() && movable(); }

  /// Cycles a minute. Throws `UsageError` outside what the sequence allows.
  void setRatePerMinute(double rate);
  /// Prescribes the volume of an organ, or none, and shows it. Throws `DataError` that names the instant at
  /// which it cannot be reached, and then changes nothing.
  void prescribe(const std::optional<PrescribedVolume>& volume);
  const MotionRunner& runner() const { return runner_; }

  double ratePerMinute() const { return runner_.ratePerMinute(); }
  double periodSeconds() const { return runner_.periodSeconds(); }
  /// The place in the cycle, [0, 1); 1 at the end of one that does not loop.
  double fraction() const { return fraction_; }
  /// Seconds since the beginning of the cycle at the present rate.
  double secondsInCycle() const { return fraction_ * periodSeconds(); }
  /// The name of the phase that the position lies in; empty when there is none.
  std::string phase() const;

  bool playing() const { return transport_.playing() && sequence(); }
  bool loop() const { return transport_.loop(); }
  double speed() const { return transport_.speed(); }
  double playedSeconds() const { return transport_.playedSeconds(); }

private:
  friend class Transport;

  void show();
  void pass(double seconds);

  Transport& transport_;
  const document::DocumentState& state_;
  live::LiveBinding& live_;
  MotionRunner runner_;
  document::OrganId organ_;
  double fraction_ = 0;
};

} // namespace viscera::motion
