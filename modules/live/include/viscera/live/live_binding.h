#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "viscera/coordinates/binding.h"
#include "viscera/coordinates/registry.h"
#include "viscera/core/job_queue.h"
#include "viscera/core/parallel.h"
#include "viscera/core/phrase.h"
#include "viscera/deformation/deformer.h"
#include "viscera/document/document.h"
#include "viscera/live/posed_organs.h"

namespace viscera::live {

/// The state of an organ's binding: bound, being bound, or not possible and why.
struct BindingStatus {
  enum class State {
    unbound, ///< Too few handles for any coordinates: the organ is at rest.
    binding, ///< A worker binds it. Meanwhile the organ follows the previous binding, if there is one.
    bound,
    stale,  ///< Binding was cancelled: the organ follows the previous binding, if there is one, else it is at
            ///< rest.
    failed, ///< The organ cannot be bound to these handles: it is at rest, and `message` gives the reason.
  };
  State state = State::unbound;
  Text message = {};   ///< For a user: what is wrong and what to try. Empty when bound.
  int outsideHull = 0; ///< Failed: vertices outside the handles' hull; `addEnclosingHandles` is the remedy.
  coordinates::BindingReport report =
      {}; ///< Errors of the binding in use; `report.seconds` is the time that the window shows.
  /// Failed: vertices that lie in no group's region; `addEnclosingGroup` is the remedy.
  std::vector<int> inNoRegion = {};
  /// Failed: the organ does not fit into the given cage; `dropCage` may be the remedy.
  bool givenCage = false;
  int outsideCage = 0; ///< Failed: vertices that have no coordinates in the given cage.
};

/// An event of one organ's binding or pose; without an organ: only handles have moved.
struct LiveEvent {
  document::OrganId organ;
  bool moved = false;    ///< `points` has other values.
  bool replaced = false; ///< `points` is another array: pointers to its memory have to be updated.
  bool status = false;   ///< `status` is new.
  /// Events of other organs for the same change follow. All organs are in their final state already, so
  /// observers of all organs can wait for the last event.
  bool more = false;
};

/// Keeps every organ of a document bound to its handles and in the pose that is shown. Edits of the rest
/// handles, of the system and its parameters bind anew, at once when that takes less than a frame, else on
/// the job queue in a slot of each organ ("bind/<id>"), with the old binding in use until the new one is
/// there. While a handle is dragged at rest, or a parameter's slider moves, a binding under way is completed
/// and used, and the next one begins with the newest state, so that the organ follows however long a binding
/// takes. It never changes the document. For the document's thread.
///
///     const double always = std::numeric_limits<double>::infinity(); // No event loop.
///     LiveBinding live(document, registry, jobs, {always, {}});
///     undo.perform(document::setPose(pose));
///     const Points& points = live.points(organ);
class LiveBinding final : public PosedOrgans {
public:
  struct Options {
    /// Binding anew is done at once when it is expected to take no longer, all organs together, s. 0: always
    /// on the queue; infinity: never, for programs without an event loop.
    double frameSeconds = 1.0 / 60.0;
    Threads threads;
  };

  /// All three must live longer.
  LiveBinding(document::Document& document, const coordinates::Registry& registry, JobQueue& jobs,
              Options options);
  LiveBinding(document::Document& document, const coordinates::Registry& registry, JobQueue& jobs);
  ~LiveBinding() override;
  LiveBinding(const LiveBinding&) = delete;
  LiveBinding& operator=(const LiveBinding&) = delete;

  /// Sets the pose that the organs take: the document's (the default), rest (editing handles at rest), or
  /// another one (`n x 3` in the order of the rig), for playing a sequence without touching the document. A
  /// given pose is dropped for the document's when the rig changes. Throws `DataError` for a pose of another
  /// size or not finite.
  void showDocumentPose();
  void showRest();
  void showPose(const Points& pose) override;
  /// The displayed positions of the handles, `n x 3`, in the order of the rig.
  const Points& shownPose() const override;
  /// The same, with what keeps it. The document's own pose is shared with it, not copied; a pose does not
  /// change after it was shown.
  std::shared_ptr<const Points> sharedPose() const;

  /// The members below throw `UsageError` for an organ that the document does not have.
  ///
  /// The organ's vertices now, `n x 3`. The reference is valid until all observers were notified of an event
  /// with `replaced`, or of the organ's removal.
  const Points& points(document::OrganId organ) const;
  std::shared_ptr<const Points> sharedPoints(document::OrganId organ) const override;
  std::uint64_t revision(document::OrganId organ) const override;
  /// The bound organ, or null when it is shown at rest because there is no binding.
  deformation::Deformer* deformer(document::OrganId organ);
  BindingStatus status(document::OrganId organ) const;
  OrganVolume volume(document::OrganId organ) override;
  /// How often surfaces were measured so far: at most once for a pose, for any number of readers. Tests and
  /// benchmarks read it.
  std::uint64_t measurings() const;
  /// The influence of a handle on every vertex, or empty when the organ is not bound to it.
  Values influence(document::OrganId organ, document::HandleId handle) const override;
  /// The influence of every handle of the document, in its order, on one vertex: 0 of a handle that the
  /// organ is not bound to; empty when there is no binding, or no such vertex in it. O(handles) for weights.
  Values weightsAt(document::OrganId organ, Eigen::Index vertex) const;
  const deformation::Deformer* bound(document::OrganId organ) const override;

  /// A copy of the present organs with their bindings, for posing them on another thread. O(points).
  PosedCopy copy() const;

  /// Tries again for organs that are stale.
  void rebind();
  /// Whether any organ waits for a worker.
  bool busy() const;

  /// Calls `observer` with every event of an organ, after a change of the document has updated everything
  /// that is derived from it. The event of a new organ has `replaced` and `status`.
  [[nodiscard]] Subscription onEvent(std::function<void(const LiveEvent&)> observer);
  /// Serves objects derived from the shown pose: called when it has changed, before observers are notified.
  [[nodiscard]] Subscription onDerive(std::function<void()> bringUpToDate);

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace viscera::live
