#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "viscera/coordinates/registry.h"
#include "viscera/core/job_queue.h"
#include "viscera/core/parallel.h"
#include "viscera/deformation/selection_motion.h"
#include "viscera/deformation/volume_lock.h"
#include "viscera/document/document.h"
#include "viscera/live/locked_motion.h"
#include "viscera/live/posed_organs.h"

/// Keeps the locked volumes of a document while handles are moved.
namespace viscera::live {

/// A handle mirrors another when it is this near to its image, as a part of the diagonal of all handles.
inline constexpr double kMirrorTolerance = 0.06;
/// Handles that make up for a volume go at most this far, as a part of the diagonal of all handles.
inline constexpr double kFarthestCompensation = 0.5;
/// A volume that differs from the one at rest by less than this (relative) is set to the one at rest, so that
/// it does not drift.
inline constexpr double kSameVolume = 1e-9;

/// A volume that an organ is to have in a motion, whether or not its volume is locked.
struct AskedVolume {
  document::OrganId organ;
  double mm3 = 0;
};

/// What the other handles do while some are moved.
enum class Others {
  asMarked,   ///< Those that the user marked make up for a locked volume; without any, the moved handles stay
              ///< where the volume lets them.
  compensate, ///< The marked ones, else all free ones: the moved handles go exactly where they are sent.
  follow,     ///< All that are not locked go to where the elastic energy of the organs' tissue is least, and
              ///< keep the locked volumes: the moved handles go exactly where they are sent.
};

class LockPreparation;
struct KnownTissue;

/// Creates the `LockedMotion` of a drag or a typed number, which keeps the document's locked volumes. The
/// volume that a lock keeps is the one that the organ has when the motion begins. Organs that do not follow
/// the handles (they are unbound) keep theirs anyway. For the thread of the organs.
class VolumeKeeper {
public:
  /// All must live longer. `state` is the document's own, which is read in every call, or the one of which
  /// `organs` are a copy. With a job queue the volume forms (`VolumeLock`) are made there, and a motion that
  /// begins before they are ready does without; the queue's main thread is that of the organs. Without one
  /// the first motion that needs a form waits for it.
  VolumeKeeper(const document::DocumentState& state, PosedOrgans& organs, Threads threads = {},
               JobQueue* jobs = nullptr);

  /// The systems of which handles that follow (`Others::follow`) take the coordinates in the tissue; they
  /// must live longer.
  void setSystems(const coordinates::Registry& systems) { systems_ = &systems; }

  /// Prepares the locks of the document for the next motion on the job queue, if there is one. Call it when
  /// other organs are locked or have been bound. Locks that are ready or under way for the same bindings are
  /// kept.
  void prepare();
  /// Cancels the preparation for organs that are no longer locked or are bound otherwise; quicker than
  /// `prepare`, for a series of changes.
  void dropOutdated();

  /// A motion of these handles from the document's pose; locked handles among them are left out. With the
  /// unit normal of a `plane` its translations stay in that plane (`LockedMotion::Setup`). Throws `DataError`
  /// when an organ with a locked volume is still being bound: its volume is not known yet. The first motion
  /// with `Others::follow` after other handles, organs or coordinates takes about a second; it throws as
  /// `tissueEnergy`, also where every organ is rigid or fixed, and `UsageError` without `setSystems`.
  LockedMotion begin(const std::vector<document::HandleId>& handles,
                     const std::optional<deformation::MirrorPlane>& mirror = std::nullopt,
                     const std::optional<Vec3>& plane = std::nullopt, Others others = Others::asMarked);

  /// The pose in which an organ has another volume, mm^3: the compensating handles, or all that are free,
  /// move as little as that takes, and other locked volumes stay. Throws `DataError` when there is none
  /// within `kFarthestCompensation`, for an open surface, for a volume that is not positive, or when the
  /// organ follows no handles.
  Points poseOfVolume(document::OrganId organ, double targetMm3);

  /// Restores the locked volumes in a pose that is not from a drag, such as a sequence's: the compensating
  /// handles, or all that are free, move as little as the volumes need. The volumes are those in the
  /// document's pose. One organ may be given another volume than that. `restored` is false, with the reason,
  /// if that needs too large a motion. Throws as `begin`, and as `poseOfVolume` for an organ that can have no
  /// volume.
  deformation::RestoredPose keep(const Points& wanted, const std::optional<AskedVolume>& asked = {});

  /// The rows of the mirror partners of these handles, or -1.
  std::vector<int> partners(const std::vector<document::HandleId>& handles,
                            const deformation::MirrorPlane& mirror) const;

private:
  std::shared_ptr<deformation::VolumeLock>
  lockOf(const std::vector<std::shared_ptr<const document::Organ>>& organs);
  void takeTargets(deformation::VolumeLock& lock,
                   const std::vector<std::shared_ptr<const document::Organ>>& organs) const;
  std::vector<std::shared_ptr<const document::Organ>> lockedOrgans();
  std::vector<deformation::LockedSurface>
  surfacesOf(const std::vector<std::shared_ptr<const document::Organ>>& organs) const;
  std::vector<deformation::LockedSurface> preparable();
  std::shared_ptr<const document::Organ> requireVolume(document::OrganId id) const;
  std::vector<int> compensating(const std::vector<int>& moving) const;
  std::vector<int> freeBut(const std::vector<int>& moving) const;
  std::shared_ptr<const elasticity::LeastEnergy> tissue();
  bool anyMarked(const std::vector<int>& rows) const;
  double limitMm() const;

  const document::DocumentState& state_;
  PosedOrgans& organs_;
  Threads threads_;
  std::shared_ptr<deformation::VolumeLock> lock_; ///< The lock of the last motion, since the next one is
                                                  ///< likely to need it.
  std::shared_ptr<LockPreparation> preparation_;  ///< Null without a job queue.
  const coordinates::Registry* systems_ = nullptr;
  std::shared_ptr<const KnownTissue> tissue_; ///< Of the last motion that handles followed; null without.
};

} // namespace viscera::live
