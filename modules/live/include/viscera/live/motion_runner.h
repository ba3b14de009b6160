#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/job_queue.h"
#include "viscera/core/parallel.h"
#include "viscera/core/phrase.h"
#include "viscera/document/document.h"
#include "viscera/live/posed_organs.h"
#include "viscera/live/volume_keeper.h"
#include "viscera/sequences/curve.h"
#include "viscera/sequences/sequence.h"

namespace viscera::live {

/// The prescribed volume of an organ over a cycle, which replaces the volume that its motion would give.
struct PrescribedVolume {
  document::OrganId organ;
  sequences::Curve milliliters; ///< Over the fraction of the cycle, with period 1.
  std::string file = {};        ///< The name of the file from which it was read, for texts.
};

/// Poses organs at an instant of a sequence. The window, movies and `viscera play` use it for every frame.
/// Locked volumes and a prescribed one are met exactly: the compensating handles move as little as possible
/// (`VolumeKeeper`). For the thread of the organs; it does not change a document.
class MotionRunner {
public:
  /// How many instants of a cycle `requireReachable` tries.
  static constexpr int kTriedInstants = 64;

  /// Both must live longer. `state` is the document's own, or the one of which `organs` are a copy.
  /// With a job queue, whose main thread is that of the organs, the volume forms of locks are prepared there,
  /// and no frame waits for them: until they are ready frames take longer, with volumes as exact and the same
  /// pose up to rounding. Without a queue the first frame that needs them waits.
  MotionRunner(const document::DocumentState& state, PosedOrgans& organs, Threads threads = {},
               JobQueue* jobs = nullptr);

  /// Takes another sequence (or none) at its standard rate; nothing is prescribed then.
  void setSequence(std::shared_ptr<const sequences::Sequence> sequence);
  const std::shared_ptr<const sequences::Sequence>& sequence() const { return sequence_; }
  /// Cycles a minute. Throws `UsageError` outside what the sequence allows, and without one.
  void setRatePerMinute(double rate);
  double ratePerMinute() const { return rate_; } ///< 0 without a sequence.
  double periodSeconds() const { return rate_ > 0 ? 60.0 / rate_ : 0; }

  const document::DocumentState& state() const { return state_; }
  const PosedOrgans& organs() const { return organs_; }

  /// Whether the handles are the sequence's, so that it can move them. O(handles).
  bool movable() const;
  /// Throws `UsageError` unless `movable`.
  void requireMovable() const;

  /// Prescribes a volume, or none.
  void prescribe(std::optional<PrescribedVolume> volume);
  const std::optional<PrescribedVolume>& prescribed() const { return prescribed_; }
  /// A number that changes whenever sequence, rate or prescribed volume are set, so that the cycle may be
  /// different.
  std::uint64_t revision() const { return revision_; }
  /// Throws `DataError` that names the first instant at which the volumes cannot be kept or met.
  /// O(`kTriedInstants`) restorations.
  void requireReachable();

  /// Poses the organs as they are `seconds` after the beginning, where `movable`. Where volumes cannot be
  /// kept, the last pose in which they could stays. Throws `DataError` as `PosedOrgans::showPose`.
  void show(double seconds);
  /// The pose that `show` would give the handles there, `n x 3` mm; none where volumes cannot be kept. The
  /// sequence has to be `movable`.
  std::optional<Points> poseAt(double seconds);
  /// Why the volumes could not be kept in the pose asked for last; empty when they were.
  const Text& obstacle() const { return obstacle_; }
  /// The volume of each organ of the document in the pose that is shown, in the document's order, ml; 0 for
  /// an open surface. Measured once for a pose, as `PosedOrgans::volume`.
  std::vector<double> volumesMl() const;

private:
  bool keepsVolumes() const;
  deformation::RestoredPose restoredPose(double seconds);

  const document::DocumentState& state_;
  PosedOrgans& organs_;
  VolumeKeeper keeper_;
  std::shared_ptr<const sequences::Sequence> sequence_;
  double rate_ = 0;
  std::optional<PrescribedVolume> prescribed_;
  std::uint64_t revision_ = 0;
  Text obstacle_;
  Points pose_; ///< The last pose of the sequence.
};

} // namespace viscera::live
