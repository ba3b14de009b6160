#pragma once

#include <QObject>

#include <memory>
#include <optional>
#include <vector>

#include "viscera/document/organ_commands.h"
#include "viscera/live/measured_record.h"
#include "viscera/live/motion_series.h"
#include "viscera/live/patient_motion.h"
#include "window/timeline/playback.h"
#include "window/view/picture.h"
#include "window/work/workspace.h"

namespace viscera::app {

/// Finds a patient's own motion in a series of phases, on a worker, and adds it to the document as organs
/// with handles and a key sequence in one undo step. It keeps the measurements as long as these organs
/// are in the document. While the sequence is shown, the view can show the measured surfaces of the nearest
/// phase, transparent, and the distances from them as colours on the organs. A session saves the numbers
/// (measured volumes and how well each phase fits), but not the surfaces.
class MeasuredMotion final : public QObject {
  Q_OBJECT

public:
  /// A tracked motion, with the series and the options from which it was found.
  struct Found {
    live::SeriesRequest request;
    live::TrackOptions options;
    std::shared_ptr<const live::MotionSeries> series;
    std::shared_ptr<const live::PatientMotion> motion;
  };

  MeasuredMotion(Workspace& workspace, Playback& playback, Picture& picture, QObject* parent = nullptr);
  ~MeasuredMotion() override;

  /// Begins to track the motion of a series on a worker, and cancels a search under way. `ended` is emitted
  /// with the outcome.
  void find(const live::SeriesRequest& request, const live::TrackOptions& options);
  void cancel();

  /// The motion whose organs are in the document; null without one.
  const Found* present() const { return present_; }
  /// The motion that was present before it, for comparison; null without one.
  const Found* before() const;
  /// The surface of the motion before that corresponds to a surface of the present one: by its name, or
  /// because both have one surface; else none.
  std::optional<std::size_t> surfaceBefore(std::size_t surface) const;
  /// The surface of the present motion that an organ was made from; none for other organs.
  std::optional<std::size_t> surfaceOf(document::OrganId organ) const;
  /// Whether the measured surfaces are available; false for a motion from a session.
  bool surfacesKnown() const;
  /// A caution about the limits of stress maps of the present motion; empty for none.
  QString caution() const;
  /// The numbers of the present motion for a session; empty without one.
  std::optional<live::MeasuredRecord> record() const;
  /// Restores the numbers of a session whose organs are in the document.
  void recall(live::MeasuredRecord record);
  /// The phase nearest to the instant that is shown.
  std::size_t phaseNow() const;
  /// Shows the instant of a phase.
  void showPhase(std::size_t phase);

  bool ghostShown() const { return ghost_; }
  bool distancesShown() const { return distances_; }
  /// The number of measured surfaces in the view.
  std::size_t ghostCount() const { return ghosts_; }
  void setGhostShown(bool on);
  void setDistancesShown(bool on);

Q_SIGNALS:
  /// The present motion or the known ones have changed.
  void changed();
  /// A motion was found and its organs are in the document.
  void found();
  /// The search has ended: `refusal` says why it failed, or is empty. Not emitted after `cancel`.
  void ended(const QString& refusal);

private:
  void take(const Found& found, const std::vector<document::NewOrgan>& organs);
  void know(const Found& found);
  void say(const Found& found);
  void sync();
  void followSoon();
  void follow();
  void clearView();
  const live::MeasuredPhase* measured(std::size_t phase);
  presentation::SurfaceMap distanceMap(const live::MeasuredPhase& measured) const;

  Workspace& workspace_;
  Playback& playback_;
  Picture& picture_;
  std::vector<Found> known_; ///< The latest is last; undo may make an earlier one present again.
  const Found* present_ = nullptr;
  std::vector<std::unique_ptr<live::MeasuredPhase>> phases_; ///< Phases of the present motion; null: not
                                                             ///< requested.
  QString said_; ///< The message with the present motion's result.
  int searches_ = 0;
  bool making_ = false;   ///< A worker computes a measured phase.
  bool reported_ = false; ///< An error about a phase's surfaces was reported for this motion.
  bool ghost_ = true;
  bool distances_ = false;
  bool drawn_ = false; ///< The view shows measured surfaces or distances.
  bool waiting_ = false;
  std::optional<std::size_t> ghostOf_; ///< The phase whose surfaces are in the view.
  std::size_t ghosts_ = 0;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
