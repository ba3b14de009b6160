#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/core/phrase.h"
#include "viscera/deformation/selection_motion.h"
#include "viscera/deformation/volume_lock.h"
#include "viscera/elasticity/least_energy.h"

namespace viscera::live {

/// Moves handles under volume locks, for one drag or one typed number: given target positions of the handles,
/// it finds the pose that keeps every locked volume and comes as near to them as that allows. Every target
/// counts from the pose at the start, so a drag that returns to its start restores that pose.
///
/// How a lock acts:
/// * A selection that moves as a whole, alone or with its mirror image, under one lock: the motion is
///   projected onto the surface of constant volume, a plane for a selection alone (the thesis's 5.1.3), and
///   nothing else moves.
/// * Anything else (rotation, scaling, several locks, or handles that the user made compensate): the handles
///   go to their targets, and the others compensate for the volume by the least displacement.
/// * Translations that are held to a plane (`Setup::plane`) are corrected along it only: a selection alone
///   then goes along the line in which it meets the plane of the lock.
/// * With a `Setup::tissue` the moved handles go to their targets, and the handles `following` to where its
///   elastic energy is least under the locks; locks are then met as exactly as without. A pose depends on the
///   way there by no more than the tolerance of `elasticity::LeastEnergy::relax`.
/// * Where that would take more than `limitMm`, the handles stop on their way, and `obstacle` gives the
///   reason.
///
/// A target costs one to three evaluations of the volumes when it is bent, about four evaluations and
/// gradients when others compensate. For one thread; free of VTK and Qt.
class LockedMotion {
public:
  /// A motion that the mirror images of the handles take part in.
  struct Mirror {
    deformation::MirrorPlane plane;
    std::vector<int> partners; ///< One for each handle of the selection, or -1 (`mirrorPartners`).
  };

  struct Setup {
    std::shared_ptr<const deformation::VolumeLock> lock; ///< Null when nothing is locked.
    Points start;                                        ///< `n x 3` mm; has the locked volumes.
    std::vector<int> selection;                          ///< The handles that are moved, ascending.
    std::optional<Mirror> mirror = std::nullopt;
    std::vector<int> compensating = {}; ///< The handles that may compensate for the volume, ascending.
    bool alwaysCompensate = false;      ///< They do so even where the motion could be bent instead: the
                                        ///< selection then goes exactly where it is sent, or part of the way.
    double limitMm = 0;                 ///< The farthest that one of them may go.
    /// The unit normal of a plane in which translations of the selection stay, such as that of the slice in
    /// which the mouse drags.
    std::optional<Vec3> plane = std::nullopt;
    /// The tissue that decides where the handles `following` (ascending) go; null: they stay.
    std::shared_ptr<const elasticity::LeastEnergy> tissue = {};
    std::vector<int> following = {};
  };

  explicit LockedMotion(Setup setup);

  /// Each of the functions below replaces the previous target, counts from the start, and returns `pose()`.
  ///
  /// Moves the selection by `wanted` (mm), or what of it lies in `Setup::plane`, and its partners by the
  /// mirrored vector.
  const Points& translate(const Vec3& wanted);
  /// Turns the selection about `center` by `angle` (rad) around the unit `axis`.
  const Points& rotate(const Vec3& center, const Vec3& axis, double angle);
  /// Scales the selection about `center` along x, y and z.
  const Points& scale(const Vec3& center, const Vec3& factors);
  /// Moves the selection to its places in `wanted` (`n x 3`).
  const Points& reach(const Points& wanted);

  /// The last pose that kept the volumes, `n x 3`; at first the start.
  const Points& pose() const { return *pose_; }
  /// The same, for a document that takes it without a copy: it does not change.
  std::shared_ptr<const Points> sharedPose() const { return pose_; }
  const Points& start() const { return setup_.start; }
  const std::vector<int>& selection() const { return setup_.selection; }
  /// The unit normal of the plane in which the lock lets the selection be translated, the way in which the
  /// volume grows; zero when no plane binds it. With a mirror it is the tangent plane at the start.
  Vec3 planeNormal() const;
  /// The last translation that was asked for, in the plane that holds it; none: the last target was another.
  const std::optional<Vec3>& asked() const { return asked_; }
  /// How far the first handle of the selection has moved since the start, mm; zero without a selection.
  Vec3 given() const;
  /// Why the volumes did not allow the last target; empty if they did.
  const Text& obstacle() const { return obstacle_; }

private:
  enum class Way { free, bent, compensated };

  Points moved(const Vec3& by) const;
  Points gradientsOfMotion(const Points& pose) const;
  void chooseWay();
  double leastInfluence(std::size_t surface) const;
  Vec3 inPlane(const Vec3& vector) const;
  Vec3 correction(const Vec3& gradient) const;
  void take(Points pose) { pose_ = std::make_shared<const Points>(std::move(pose)); }
  bool bend(const Vec3& wanted);
  Points followed(const Points& wanted) const;
  bool compensate(const Points& wanted);
  const Points& compensateUpTo(const Points& wanted);
  double relativeError(const std::vector<double>& volumes) const;

  Setup setup_;
  std::vector<int> partners_; ///< Those that move and are not themselves selected, each once.
  std::size_t bending_ = 0;   ///< The one surface that the motion is bent for.
  Way translations_ = Way::free;
  Vec3 gradient_ = Vec3::Zero(); ///< Of its volume, for the motion as a whole, at the start.
  std::shared_ptr<const Points> pose_;
  Points wanted_;                ///< The last target that was reached, before other handles compensated.
  Vec3 wantedBy_ = Vec3::Zero(); ///< The same for a translation that was bent.
  std::optional<Vec3> asked_;
  Text obstacle_;
};

/// Throws `DataError` with the reason where the volumes did not let the selection move by `by` (mm).
void requireExact(const LockedMotion& motion, const Vec3& by);

} // namespace viscera::live
