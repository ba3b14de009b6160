#pragma once

#include <QObject>
#include <QTimer>

#include <optional>

#include "viscera/live/volume_keeper.h"
#include "window/view/view_model.h"
#include "window/work/workspace.h"

namespace viscera::app {

/// Moves handles in the pose, for the mouse and for typed numbers: it keeps the locked volumes, mirrors the
/// motion if a mirror is on, and makes one undo step of every gesture.
class PoseEditor final : public QObject {
  Q_OBJECT

public:
  /// `model` holds which mirror is on.
  PoseEditor(Workspace& workspace, const ViewModel& model, QObject* parent = nullptr);

  /// Begins a gesture with these handles; `mirrored`: their partners move along when a mirror is on; `plane`:
  /// the unit normal of the plane that its translations keep to. If that is not possible now, shows a message
  /// and returns false.
  bool begin(const QString& name, const std::vector<document::HandleId>& handles, bool mirrored,
             const std::optional<Vec3>& plane = std::nullopt);
  bool active() const { return motion_.has_value(); }
  /// The motion of the present gesture, or null.
  const live::LockedMotion* motion() const { return motion_ ? &*motion_ : nullptr; }
  /// Sets the whole motion since the gesture began. Nothing happens without a gesture.
  void translate(const Vec3& by) {
    follow([&by](live::LockedMotion& motion) { motion.translate(by); });
  }
  void rotate(const Vec3& center, const Vec3& axis, double angle) {
    follow([&](live::LockedMotion& motion) { motion.rotate(center, axis, angle); });
  }
  void scale(const Vec3& center, const Vec3& factors) {
    follow([&](live::LockedMotion& motion) { motion.scale(center, factors); });
  }
  void finish() { end(&document::UndoStack::Step::finish); }
  void cancel() { end(&document::UndoStack::Step::cancel); }

  /// Moves handles by a vector, mm, mirrored if a mirror is on. Returns the motion of the first one, or empty
  /// if that was not possible. Where a locked volume leaves less than was asked, a message offers
  /// `moveExactly`.
  std::optional<Vec3> moveBy(const std::vector<document::HandleId>& handles, const Vec3& by);
  /// The same by exactly this vector: other handles compensate for locked volumes. Where they cannot, nothing
  /// moves and a message gives the reason; returns false.
  bool moveExactly(const std::vector<document::HandleId>& handles, const Vec3& by);
  /// Moves handles back to rest; with locked volumes, other handles compensate.
  void reset(const std::vector<document::HandleId>& handles);
  /// Gives an organ another volume; false when it cannot be reached. Like the functions below, it ends the
  /// present gesture, because it changes the locked volumes.
  bool setVolume(document::OrganId organ, double milliliters);
  /// Locks or unlocks organs' volumes in one undo step; offers to close surfaces that are open.
  void setLocked(const std::vector<document::OrganId>& organs, bool locked);
  /// Sets whether the selected handles compensate.
  void setCompensating(bool compensating);

  /// The mirror plane; none when no mirror is on or there is no organ.
  std::optional<deformation::MirrorPlane> mirrorPlane() const;
  /// The mirror partners of the selected handles.
  std::vector<document::HandleId> partnersOfSelection() const;

Q_SIGNALS:
  /// A gesture began, went on or ended.
  void gestureChanged();
  /// Why the gesture does not follow the mouse; empty when it does again, or is over.
  void obstacleChanged(const QString& obstacle);

private:
  void offerToClose(const std::vector<document::OrganId>& organs);
  void prepareLocks();
  void follow(const std::function<void(live::LockedMotion&)>& wish);
  void setObstacle(const QString& obstacle);
  void end(void (document::UndoStack::Step::*close)());
  live::Others others() const;
  QString shortfall(const live::LockedMotion& motion) const;
  void tellDifference(const live::LockedMotion& motion);
  document::Command moveCommand(const live::LockedMotion& motion,
                                const std::vector<document::HandleId>& handles) const;

  Workspace& workspace_;
  const ViewModel& model_;
  live::VolumeKeeper keeper_;
  QTimer prepareSoon_; ///< Ends when handles at rest and locks have not changed for a while.
  std::optional<live::LockedMotion> motion_;
  QString told_; ///< The last message about a move that a locked volume cut short.
  std::optional<document::UndoStack::Step> step_; ///< The undo step of the present gesture.
  QString obstacle_;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
