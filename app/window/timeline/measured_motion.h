#pragma once

#include <QObject>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "viscera/document/organ_commands.h"
#include "viscera/document/study_item.h"
#include "viscera/live/cine_motion.h"
#include "viscera/live/measured_record.h"
#include "viscera/live/motion_series.h"
#include "viscera/live/patient_motion.h"
#include "window/timeline/playback.h"
#include "window/view/picture.h"
#include "window/work/workspace.h"

namespace viscera::app {

/// Finds a patient's own motion in a series of phases, or in cine images and labels of a few phases, on a
/// worker, and adds it to the document as organs with handles and a key sequence in one undo step. It keeps
/// the measurements as long as these organs are in the document. While the sequence is shown, the view can
/// show the measured surfaces of the nearest phase, transparent, and the distances from them as colours on
/// the organs. A session saves the numbers (measured volumes and how well each phase fits), but not the
/// surfaces.
class MeasuredMotion final : public QObject {
  Q_OBJECT

public:
  /// A tracked motion, with the series and the options from which it was found.
  struct Found {
    live::SeriesRequest request;
    live::TrackOptions options;
    std::shared_ptr<const live::MotionSeries> series;
    std::shared_ptr<const live::PatientMotion> motion;
    /// How it was found from images, with their request; null where every phase was labelled.
    std::shared_ptr<const live::CineRecord> images = nullptr;
    /// The surfaces of the labelled phases; null without images, and in a session.
    std::shared_ptr<const live::MotionSeries> labels = nullptr;
  };

  /// A motion on its way into the document.
  struct Result;

  MeasuredMotion(Workspace& workspace, Playback& playback, Picture& picture, QObject* parent = nullptr);
  ~MeasuredMotion() override;

  /// Begins to track the motion of a series on a worker, and cancels a search under way. `ended` is emitted
  /// with the outcome.
  void find(const live::SeriesRequest& request, const live::TrackOptions& options);
  /// The same from images and the labels of some phases. `study` has the images of the request; null: they
  /// are read. The document gets the study in the same step where it has another one or none.
  void findFromImages(const live::CineRequest& request, const live::TrackOptions& options,
                      std::shared_ptr<const document::StudyItem> study);
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
  /// The images of the present motion and what they said; null where there are none.
  const live::CineMotion* images() const;
  /// Whether the numbers of the present motion are estimates: images and labels of one phase only.
  bool isEstimate() const;
  /// Whether a phase of the present motion was measured: it has labels.
  bool isLabelled(std::size_t phase) const;
  /// Whether the present motion was found from the images of the document's study.
  bool isOfStudy() const;
  /// Whether the measured surfaces are available; false for a motion from a session.
  bool surfacesKnown() const;
  /// A caution about the limits of stress maps of the present motion; empty for none.
  QString caution() const;
  /// The numbers of the present motion for a session; empty without one.
  std::optional<live::MeasuredRecord> record() const;
  /// Restores the numbers of a session whose organs are in the document.
  void recall(live::MeasuredRecord record);
  /// Takes the numbers of the present motion from one that was fitted to other corrected contours: the same
  /// organs and handles with other poses, which the document has already.
  void takeCorrected(const live::CineMotion& corrected);
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
  /// Finds a motion on a worker, and takes it into the document.
  void search(const QString& name, std::function<Result(Progress&)> work);
  void take(const Found& found, const std::vector<document::NewOrgan>& organs,
            const std::shared_ptr<const document::StudyItem>& study);
  void know(const Found& found);
  void say(const Found& found);
  void sync();
  void followSoon();
  void follow();
  void clearView();
  const live::MeasuredPhase* measured(std::size_t phase);
  std::shared_ptr<const live::MotionSeries> shownSeries() const;
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
