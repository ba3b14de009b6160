#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/coordinates/coordinate_system.h"
#include "viscera/coordinates/registry.h"
#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/deformation/deformer.h"
#include "viscera/deformation/pose_together.h"
#include "viscera/document/document.h"
#include "viscera/live/live_binding.h"

/// Binds one organ of a document to its handles and poses it, for `LiveBinding`.
namespace viscera::live {

/// The handles, system and parameters to which all organs of a document are bound.
struct BindingTarget {
  std::shared_ptr<const coordinates::CoordinateSystem> system; ///< Null when there is none of that id.
  Text problem;                                                ///< Why there is none.
  coordinates::ParameterValues parameters;
  coordinates::HandleSet handles;
  std::vector<document::HandleId> ids; ///< Of the rows of `handles.positions`.
};

BindingTarget makeTarget(const document::DocumentState& state, const coordinates::Registry& registry);

/// Whether bindings to both are equal. Groups and cages only count if the system uses them.
bool sameBinding(const BindingTarget& a, const BindingTarget& b);

/// Whether the binding uses the rig's own cage.
bool usesGivenCage(const BindingTarget& target);

/// Whether a binding to `underWay` is worth waiting for when `wanted` has taken its place: the same handles,
/// elsewhere perhaps, in the same system and cage. A drag or a slider would else give up one binding after
/// the other.
bool worthWaitingFor(const BindingTarget& underWay, const BindingTarget& wanted);

/// The status of every organ when nothing can be bound to this target; none when it is worth trying.
std::optional<BindingStatus> statusWithoutBinding(const BindingTarget& target);

/// Whether both are the same pose: most often they are shared.
inline bool samePose(const Points& a, const Points& b) {
  return &a == &b || (a.rows() == b.rows() && a == b);
}

/// What binding an organ ended with: one of the two.
struct BindingResult {
  std::unique_ptr<deformation::Deformer> deformer;
  std::optional<BindingStatus> failure;
};

/// Binds an organ. For any thread. Throws nothing but `Cancelled`: an error becomes a failure.
BindingResult bindToTarget(const document::Organ& organ, const BindingTarget& target, Threads threads,
                           Progress& progress);

/// An organ and what it hangs on.
class BoundOrgan {
public:
  explicit BoundOrgan(std::shared_ptr<const document::Organ> unbound) : organ(std::move(unbound)) {}

  std::shared_ptr<const document::Organ> organ;
  BindingStatus status;
  std::shared_ptr<deformation::Deformer> deformer; ///< Null: at rest.
  std::shared_ptr<const BindingTarget> boundTo;    ///< What `deformer` was bound to; null without one.
  std::shared_ptr<const BindingTarget>
      attempted;                                 ///< The last target that was tried, with success or without.
  std::shared_ptr<const BindingTarget> underWay; ///< What a worker binds it to while `binding`.
  std::int64_t ticket = 0;                       ///< Of the last job that was asked to bind it.
  std::uint64_t revision = 0;                    ///< Another number after every move of the points.
  LiveEvent pending;                             ///< The event that was not sent yet.

  /// The slot of the job queue in which it is bound.
  std::string slot() const { return "bind/" + std::to_string(organ->id.value); }
  /// The points, with what keeps them.
  std::shared_ptr<const Points> sharedPoints() const {
    return deformer ? std::shared_ptr<const Points>(deformer, &deformer->points())
                    : std::shared_ptr<const Points>(organ->mesh, &organ->mesh->points);
  }
  const Points& points() const { return deformer ? deformer->points() : organ->mesh->points; }
  /// Measures the surface when that was not done in its pose yet.
  OrganVolume volume() const;
  /// Whether `volume` measures nothing.
  bool volumeKnown() const { return !deformer || !organ->closed() || deformer->volumeKnown(); }
  Values influence(document::HandleId handle) const;
  /// The same as `LiveBinding::weightsAt`, for handles of the document.
  Values weightsAt(Eigen::Index vertex, const std::vector<document::Handle>& handles) const;
  /// The same as `PosedOrgans::bound`.
  const deformation::Deformer* bound() const;

  /// Takes a result that was made for `of`.
  void take(BindingResult result, std::shared_ptr<const BindingTarget> of);
  /// Takes a status that holds no binding.
  void fail(BindingStatus failure);
  void setState(BindingStatus::State state);

  /// The work that poses the organ in `pose`, which belongs to the handles of `now`: none when it is in that
  /// pose already, or at rest at once. While a user drags, a few handles are moved by their columns only; the
  /// next pose that is not interactive is computed in full, so that what a drag leaves behind depends on
  /// where it ended and not on its way. The caller poses the organ before its points are read.
  std::optional<deformation::NewPose> poseFor(const BindingTarget& now,
                                              const std::shared_ptr<const Points>& pose, bool interactive);

private:
  std::shared_ptr<const Points> translated(const BindingTarget& now, const Points& pose) const;
  std::optional<std::vector<int>> fewMoved(const Points& pose) const;
  void moves(bool roughly);

  bool rough_ = false; ///< Moved by columns since the last full pose.
};

/// The organs that hang on the same handles, in one pose of these.
struct BoundOrgans {
  std::map<document::OrganId, BoundOrgan> organs;
  std::shared_ptr<const BindingTarget> target; ///< What every organ is to be bound to; never null.
  std::shared_ptr<const Points> shownPose = std::make_shared<const Points>(0, 3); ///< Never null.
  Threads threads = {};
  std::uint64_t measurings = 0; ///< How often surfaces were measured.

  /// The same once more; only what never changes is shared.
  std::unique_ptr<BoundOrgans> copy() const;
  /// Throws `UsageError` for an organ that is not among them.
  const BoundOrgan& require(document::OrganId id) const;
  /// Throws `DataError` for a pose of another size or one that is not finite.
  void requirePose(const Points& pose) const;
  /// Shows a pose of the caller's, which is copied. Throws as `requirePose`.
  void setShownPose(const Points& pose);
  /// Poses all organs in `shownPose`, in one parallel loop.
  void poseAll(bool interactive);
  void poseOne(BoundOrgan& organ);
  /// The same as `PosedOrgans::volume`.
  OrganVolume volume(document::OrganId id);

private:
  void measureMoved();
};

} // namespace viscera::live
