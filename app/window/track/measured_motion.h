#pragma once

#include <QObject>

#include <memory>
#include <optional>
#include <vector>

#include "viscera/document/organ_commands.h"
#include "viscera/motion/motion_series.h"
#include "viscera/motion/patient_motion.h"
#include "window/timeline/playback.h"
#include "window/view/picture.h"
#include "window/workspace.h"

namespace viscera::app {

/// Finds a patient's own motion in a series of phases and keeps it: found on a worker, taken into the
/// document as organs with handles and a recorded sequence in one undo step, and known here as long as these
/// organs are in the document, with what was measured. While the sequence is shown, the surfaces that were
/// measured in the nearest phase can stand in the view as glass, and the organs have the distances from them
/// as colours. A session keeps the numbers: measured volumes and how well each phase fits; the surfaces
/// themselves are in no session.
class MeasuredMotion final : public QObject {
  Q_OBJECT

public:
  /// A motion, and what it was found from and how.
  struct Found {
    motion::SeriesRequest request;
    motion::TrackOptions options;
    std::shared_ptr<const motion::MotionSeries> series;
    std::shared_ptr<const motion::PatientMotion> motion;
  };

  MeasuredMotion(Workspace& workspace, Playback& playback, Picture& picture, QObject* parent = nullptr);
  ~MeasuredMotion() override;

  /// Looks for the motion of a series on a worker, in the place of one that is looked for. `ended` tells how
  /// it went.
  void find(const motion::SeriesRequest& request, const motion::TrackOptions& options);
  void cancel();

  /// The motion whose organs are in the document; null without one.
  const Found* present() const { return present_; }
  /// The one that was present before it, still known, to be compared with; null without one.
  const Found* before() const;
  /// The surface of the motion before that has the name of one of the present motion's, or is the only one of
  /// both; none without one.
  std::optional<std::size_t> surfaceBefore(std::size_t surface) const;
  /// Which surface of the present motion an organ is; none for any other.
  std::optional<std::size_t> surfaceOf(document::OrganId organ) const;
  /// Whether the surfaces that were measured are known: not of a motion out of a session.
  bool surfacesKnown() const;
  /// What stress and strain of the present motion do not tell; empty where they tell all.
  QString caution() const;
  /// The numbers of the present motion as JSON for a session; empty without one.
  std::string record() const;
  /// Takes the numbers of a session whose organs are in the document. Throws `DataError` for other text.
  void recall(const std::string& record);
  /// The phase nearest to the instant that is shown.
  std::size_t phaseNow() const;
  /// Shows the instant of a phase.
  void showPhase(std::size_t phase);

  bool ghostShown() const { return ghost_; }
  bool distancesShown() const { return distances_; }
  /// How many measured surfaces stand in the view.
  std::size_t ghostCount() const { return ghosts_; }
  void setGhostShown(bool on);
  void setDistancesShown(bool on);

Q_SIGNALS:
  /// Another motion is present, or none; or one more is known.
  void changed();
  /// A motion was found and its organs are in the document.
  void found();
  /// The search is over; what was refused, else nothing. Not after `cancel`.
  void ended(const QString& refusal);

private:
  void take(const Found& found, const std::vector<document::NewOrgan>& organs);
  void know(const Found& found);
  void say(const Found& found);
  void sync();
  void followSoon();
  void follow();
  void clearView();
  const motion::MeasuredPhase* measured(std::size_t phase);
  presentation::SurfaceMap distanceMap(const motion::MeasuredPhase& measured) const;

  Workspace& workspace_;
  Playback& playback_;
  Picture& picture_;
  std::vector<Found> known_; ///< The latest last; undo brings them back.
  const Found* present_ = nullptr;
  std::vector<std::unique_ptr<motion::MeasuredPhase>> phases_; ///< Of the present one; null: not asked for.
  int searches_ = 0;
  bool making_ = false;   ///< A measured phase is on its way.
  bool reported_ = false; ///< That the surfaces of a phase of this motion cannot be made.
  bool ghost_ = true;
  bool distances_ = false;
  bool drawn_ = false; ///< The view holds something of it.
  bool waiting_ = false;
  std::optional<std::size_t> ghostOf_; ///< The phase whose surfaces are in the view.
  std::size_t ghosts_ = 0;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
