#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "binding_target.h"
#include "viscera/core/progress.h"
#include "viscera/deformation/deformer.h"

namespace viscera::live {

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
  LiveEvent pending;                             ///< What has not been told yet.
  /// Those before that somebody may still look at, until what is pending has been told.
  std::vector<std::shared_ptr<deformation::Deformer>> retired;

  /// The slot of the job queue in which it is bound.
  std::string slot() const { return "bind/" + std::to_string(organ->id.value); }
  const Points& points() const { return deformer ? deformer->points() : organ->mesh->points; }

  /// Takes a result that was made for `of`.
  void take(BindingResult result, std::shared_ptr<const BindingTarget> of);
  /// Takes a status that holds no binding.
  void fail(BindingStatus failure);
  void setState(BindingStatus::State state);

  /// Poses the organ for `pose`, which belongs to the handles of `now`. While a user drags, a few handles are
  /// moved by their columns only; the next pose that is not interactive is computed in full, so that what a
  /// drag leaves behind depends on where it ended and not on its way.
  void setPose(const BindingTarget& now, const Points& pose, bool interactive);

private:
  Points translated(const BindingTarget& now, const Points& pose) const;
  bool moveFew(const Points& pose);

  bool rough_ = false; ///< Moved by columns since the last full pose.
};

} // namespace viscera::live
