#pragma once

#include <cstdint>
#include <memory>
#include <tuple>
#include <vector>

#include "viscera/document/document.h"
#include "viscera/live/motion_runner.h"
#include "viscera/live/posed_organs.h"
#include "viscera/live/stress_frame.h"

namespace viscera::live {

/// The inputs that determine the poses of one cycle of a document's organs. A result is valid as long as its
/// cause equals `causeOf` of the same runner.
struct MotionCause {
  std::uint64_t revision = 0; ///< Revision of the runner: sequence, rate and prescribed volume.
  std::shared_ptr<const document::Rig> rig;
  std::shared_ptr<const document::SystemChoice> system;
  /// Identity of each organ, its surface, whether its volume is locked, and how it follows the handles.
  std::vector<
      std::tuple<document::OrganId, std::shared_ptr<const geometry::TriangleMesh>, bool, document::Mobility>>
      organs;
  std::shared_ptr<const Points> pose; ///< Gives locked organs their volumes; null where none is locked.
  bool operator==(const MotionCause&) const = default;
};

/// O(organs).
MotionCause causeOf(const MotionRunner& runner);

/// A copy of a runner with organs of its own, so that a worker can go through a cycle while the document
/// changes: surfaces and bindings are shared, volumes are kept or met as in the original. For one thread,
/// which need not be the document's.
///
///     auto copy = std::make_shared<MotionCopy>(player.runner(), live.copy());
///     jobs.submit<CycleCurves>("Volumes", "cycle",
///                              [copy](Progress& p) { return measureCycle(copy->runner(), p); }, take);
class MotionCopy {
public:
  MotionCopy(const MotionRunner& original, PosedCopy organs);
  MotionCopy(const MotionCopy&) = delete;
  MotionCopy& operator=(const MotionCopy&) = delete;

  MotionRunner& runner() { return runner_; }

private:
  const document::DocumentState state_;
  PosedCopy organs_;
  MotionRunner runner_;
};

/// The cycle that a runner plays, for computations over it on another thread. If volumes cannot be kept, the
/// handles stay in the last pose in which they could, as in playback. Throws `UsageError` when the runner
/// cannot move the handles.
PosedCycle posedCycle(const MotionRunner& original, PosedCopy organs);

} // namespace viscera::live
