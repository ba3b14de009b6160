#pragma once

#include <memory>
#include <string>
#include <vector>

#include "viscera/coordinates/registry.h"
#include "viscera/core/job_queue.h"
#include "viscera/core/parallel.h"
#include "viscera/core/phrase.h"
#include "viscera/deformation/rotational_stress.h"
#include "viscera/deformation/witness_gradients.h"
#include "viscera/deformation/witness_mesh.h"
#include "viscera/document/document.h"
#include "viscera/live/live_binding.h"
#include "viscera/live/stress_frame.h"
#include "viscera/live/witness_sampling.h"

namespace viscera::live {

/// The state of the stress map's computation, and its error if it failed.
struct StressStatus {
  enum class State {
    off,       ///< No organ is followed.
    sampling,  ///< A worker fills the organ with witness points.
    binding,   ///< A worker derives the coordinates at the witness points.
    ready,     ///< The map follows the pose.
    cancelled, ///< The computation was cancelled; `retry` restarts it.
    failed,    ///< `message` gives the reason.
  };
  State state = State::off;
  Text message;                                  ///< For a user; empty unless failed.
  WitnessOrigin origin = WitnessOrigin::surface; ///< Meaningful once there is a mesh.
  std::vector<Text> remarks;                     ///< Of the sampling, a sentence each.
  bool closedForm = false;                       ///< The derivatives; false: central differences.
  int outside = 0;                               ///< Points outside the handles' hull, which do not move.
};

/// An event of `LiveStress`: what has changed.
struct StressEvent {
  bool status = false;
  bool sampled = false; ///< The witness mesh has changed or was removed.
  bool moved = false;   ///< Points, map and statistics have changed.
  bool cycle = false;   ///< The stress over a cycle was computed, could not be, or is no longer valid.
};

/// Computes the rotational stress of one organ of a document in every pose that a `LiveBinding` shows. It
/// fills the organ with witness points on the job queue (slot "stress/sample"), derives the coordinates at
/// them (slot "stress/bind", or at once when that takes less than a frame), and evaluates the map whenever
/// the organ moves. The organ's cavities (closed surfaces whose parent it is) are left out: blood is no
/// tissue. When handles at rest, the system or the surface change, another binding or mesh is computed; until
/// then the previous map stays, unless it would be wrong. Results depend only on surface, number of
/// witnesses, handles and pose, to the last bit, not on the order of changes. It never changes the document.
/// For the document's thread.
class LiveStress {
public:
  struct Options {
    WitnessOptions witnesses;
    double frameSeconds = 1.0 / 60.0; ///< Binding is done at once when it is expected to take no longer.
    Threads threads;
  };

  /// All four must live longer.
  LiveStress(document::Document& document, const coordinates::Registry& registry, LiveBinding& live,
             JobQueue& jobs, Options options);
  LiveStress(document::Document& document, const coordinates::Registry& registry, LiveBinding& live,
             JobQueue& jobs);
  ~LiveStress();
  LiveStress(const LiveStress&) = delete;
  LiveStress& operator=(const LiveStress&) = delete;

  /// Sets the organ to follow; none: stops work, and keeps the results in case the same organ is followed
  /// again.
  void follow(document::OrganId organ);
  document::OrganId organ() const;
  /// Witness points to ask for, within the limits of `WitnessOptions`. Throws `UsageError` outside.
  void setWanted(int witnesses);
  int wanted() const;
  /// Tries again after a cancellation or a failure.
  void retry();

  const StressStatus& status() const;
  /// The organ's witnesses at rest; null before there are any.
  std::shared_ptr<const deformation::WitnessMesh> mesh() const;
  /// The mesh's points in the pose that is shown, `n x 3` mm, and what happens at them. Empty before the
  /// first binding. Both stay where they are until an event with `sampled`.
  const Points& points() const;
  const deformation::StressMap& map() const;
  /// Statistics of the witness points (without those on the surface), now.
  const deformation::StressStatistics& statistics() const;
  /// The axes of the ellipsoid that a small ball at `point` becomes. Identity before the first binding.
  deformation::PrincipalStretches stretchesAt(Eigen::Index point) const;
  /// The derivatives in use; null before the first binding.
  std::shared_ptr<const deformation::WitnessGradients> gradients() const;

  /// Computes the stress over a cycle (slot "stress/cycle"); the one before stays until then. The maximum
  /// takes several times as long as the curve. Throws `UsageError` when the map is not ready. A cycle of
  /// other handles makes the job fail.
  void findCycle(PosedCycle cycle, CycleParts parts);
  /// Drops the computed cycle and cancels its computation, after the sequence has changed.
  void dropCycle();
  /// The stress over the cycle, of the mesh and binding in use; null while it is not known.
  std::shared_ptr<const CycleStress> cycle() const;
  /// Whether a cycle is being computed.
  bool findingCycle() const;
  /// Why the last cycle could not be computed, for a user; empty unless that failed.
  const Text& cycleMessage() const;

  /// All results for drawing. `stretchesAt` of the frame may be called as long as this object lives.
  StressFrame frame() const;
  /// A copy that can be evaluated in poses of its own; without an organ while nothing is bound.
  StressCopy copy() const;

  [[nodiscard]] Subscription onEvent(std::function<void(const StressEvent&)> observer);

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace viscera::live
