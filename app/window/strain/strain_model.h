#pragma once

#include <QObject>
#include <QPointer>

#include <memory>
#include <optional>
#include <vector>

#include "viscera/core/job_queue.h"
#include "viscera/live/motion_copy.h"
#include "viscera/live/strain_reading.h"
#include "window/timeline/playback.h"
#include "window/work/workspace.h"

namespace viscera::app {

class MeasuredMotion;

/// What a user has chosen about how strain is measured.
struct StrainChoice {
  int reference = 0; ///< The phase to measure from, counted from 1; 0: the end of diastole is found.
  strain::AxisLandmarks axes = {};                                ///< Points that were clicked, mm at rest.
  std::shared_ptr<const geometry::TriangleMesh> axesOf = nullptr; ///< The left ventricle that they are of.

  bool operator==(const StrainChoice&) const = default;
};

/// Measures the strain of one view's heart on a worker, as long as it is wanted: over the whole cycle of its
/// motion, and in the pose of the document, against rest, while handles move it. What belongs to the heart at
/// rest is prepared once for organs, handles and coordinates; each pose then takes as long as a stress map. A
/// computation under way finishes and is shown before the next one begins with the newest pose, so that the
/// numbers follow a drag.
class StrainModel final : public QObject {
  Q_OBJECT

public:
  using Reading = std::shared_ptr<const live::StrainReading>;

  /// Both have to live longer.
  StrainModel(Workspace& workspace, Playback& playback, QObject* parent = nullptr);

  /// Sets the source of tracked motions, whose measured surfaces are read where they correspond.
  void setMeasured(const MeasuredMotion& measured);
  /// Sets whether to measure; what was measured stays.
  void setWanted(bool wanted);
  /// Sets how to measure. Other axes are a new preparation of the heart, another reference only a new
  /// reading.
  void choose(const StrainChoice& choice);

  /// Sets how many witness points fill the heart that is measured next; fewer take less time.
  void setWitnesses(int count) { witnesses_ = count; }

  /// Whether an organ is a left ventricle by its name.
  bool possible() const { return static_cast<bool>(leftVentricle()); }
  /// The first of these; none without any.
  document::OrganId leftVentricle() const;
  /// The strain over the cycle; null while there is no motion, and until it is measured.
  const Reading& cycle() const { return cycle_; }
  /// The strain of the document's pose: phase 0 is rest, phase 1 the pose. Null while the sequence's pose or
  /// that at rest is shown.
  Reading pose() const { return posed() ? pose_ : nullptr; }
  /// The phase of `cycle` nearest to the instant that is shown; the reference while none is.
  std::size_t phaseNow() const;
  /// Whether the instant of a sequence is shown, so that a cursor has a place.
  bool playing() const { return playback_.showing(); }
  double secondsNow() const { return playback_.player().secondsInCycle(); }
  /// Whether something is being measured, or will be.
  bool busy() const { return running_ || asked_; }
  /// Why nothing can be measured; empty when all is well.
  const QString& failureReason() const { return failureReason_; }
  /// The segment of each vertex of an organ, 1 to 17 or 0; null for organs without any, and before a first
  /// reading.
  const std::vector<int>* segmentsOn(document::OrganId organ) const;
  Workspace& workspace() const { return workspace_; }

Q_SIGNALS:
  /// Readings, the reason why there are none, or the pose that counts have changed.
  void changed();

private:
  /// What a gauge is made for.
  struct Basis {
    std::vector<std::pair<document::OrganId, std::shared_ptr<const geometry::TriangleMesh>>> organs;
    std::shared_ptr<const document::Rig> rig;
    std::shared_ptr<const document::SystemChoice> system;
    strain::AxisLandmarks axes = {};
    bool operator==(const Basis&) const = default;
  };
  /// The measured surfaces of a tracked motion, for the organs of the basis.
  struct Series {
    std::shared_ptr<const live::MotionSeries> series;
    std::shared_ptr<const live::PatientMotion> motion;
    std::vector<std::size_t> surfaces;
  };

  void syncSoon();
  void sync();
  bool posed() const;
  Basis basis() const;
  live::MovedOrgans atRest(const Basis& basis) const;
  std::optional<Series> series(const Basis& basis) const;
  void readPose(const Basis& basis);
  void readCycle(const Basis& basis, const live::MotionCause& cause);
  /// Measures against the phase `reference`; none, or a phase that there is not: the end of diastole.
  void submit(const Basis& basis, std::function<live::MovedOrgans(Progress&)> motion,
              std::optional<std::size_t> reference, std::function<void(const Reading&)> take);
  void forget(const Basis& now);
  void tell(const QString& reason);

  Workspace& workspace_;
  Playback& playback_;
  QPointer<const MeasuredMotion> measured_;
  bool wanted_ = false;
  StrainChoice choice_;
  int witnesses_ = live::StrainOptions().witnesses;
  live::WantedPose poseWanted_ = live::WantedPose::sequence; ///< When it was looked at last.
  bool asked_ = false; ///< `sync` is scheduled after the present notification.
  bool running_ = false;
  Basis gaugeOf_;
  std::shared_ptr<const live::StrainGauge> gauge_; ///< Null: none was made for `gaugeOf_`.
  /// The gauge of an earlier basis: its tetrahedra serve where only the axes are others.
  std::shared_ptr<const live::StrainGauge> lastGauge_;
  bool refused_ = false; ///< Whether none can be made for it.
  Reading cycle_, pose_;
  std::optional<live::MotionCause> cycleOf_; ///< Also of a cycle that could not be measured.
  std::shared_ptr<const Points> poseOf_;     ///< The document's, which `pose_` was read from.
  QString failureReason_;
  std::vector<Subscription> subscriptions_;
  JobQueue jobs_; ///< Its own: binding and stress do not wait for seconds of preparation.
};

} // namespace viscera::app
