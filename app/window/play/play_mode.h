#pragma once

#include <QPointer>

#include <functional>
#include <map>
#include <memory>

#include "viscera/presentation/presenter.h"
#include "window/circulation/circulation_model.h"
#include "window/circulation/circulation_panel.h"
#include "window/compare/comparison.h"
#include "window/key_sequence/key_sequence_playback.h"
#include "window/modes/mode.h"
#include "window/movie/movie_recorder.h"
#include "window/strain/strain_model.h"
#include "window/strain/strain_panel.h"
#include "window/timeline/measured_motion.h"
#include "window/timeline/volume_monitor.h"
#include "window/track/motion_dialog.h"
#include "window/track/residual_table.h"
#include "window/work/actions.h"

class QAction;

namespace viscera::app {

class StatusLine;

/// The mode Play, in which the user watches sequences and teaches with them: the sequences to choose from,
/// labels, see-through walls, two views, and movies.
class PlayMode final : public Mode {
  Q_OBJECT

public:
  PlayMode(const ModeParts& parts, Actions& actions);
  ~PlayMode() override;

  std::vector<const char*> actions() const override;
  QWidget* makePage(const Actions& actions) override;
  QWidget* makeChart() override;
  bool chartWanted() const override;
  presentation::Shown shown() const override { return {}; }
  live::WantedPose pose() const override { return live::WantedPose::sequence; }
  UsefulPanels panels() const override { return {false, true, parts_.playback.sequence() != nullptr}; }
  void setTheme(const Theme& theme) override;
  /// Where segments are shown on the organ, also chooses one.
  void click(const ClickedPlace* place) override;
  /// Shows what is recorded and what the second view does in the status bar.
  void setStatus(StatusLine& status);

  Comparison& comparison() { return *comparison_; }
  MovieRecorder& recorder() { return *recorder_; }
  KeySequencePlayback& keySequence() { return *keySequence_; }
  CirculationModel& circulation() { return *circulation_; }
  MeasuredMotion& measured() { return *measured_; }
  StrainModel& strain() { return *strain_; }
  /// The panel with the strain of the heart; the caller owns it.
  StrainPanel* makeStrain(const Actions& actions);
  /// Writes the strain over the cycle as a table (.csv) or as a picture (.png), by the ending.
  void exportStrain(const QString& file);
  /// The table for a motion out of a series; the caller owns it.
  QWidget* makeResiduals();
  /// Opens the dialog that asks for a series, and returns it.
  MotionDialog& chooseSeries();

  /// Shows a sequence: on the present organ if the sequence was made for it, else on its sample organ.
  void chooseSequence(const QString& id);
  /// Whether the document holds the sample heart, which a circulation can move.
  bool hasSampleHeart() const;
  /// Whether choosing that sequence would remove the user's own organs from the document.
  bool replacesOrgans(const QString& sequence) const;
  /// Lets the circulation move the heart, in a scenario or (empty) as it was last: the sample heart, which is
  /// loaded if it is not present.
  void chooseScenario(const QString& id);
  /// Plays the beat of the sample heart, whatever makes it; false when there is none.
  bool playSampleHeart();
  /// Records what the view, or both views, show.
  bool record(const MoviePlan& plan);

private:
  void makeMotionActions(Actions& actions);
  void makeComparisonActions(Actions& actions);
  void makeLookActions(Actions& actions);
  void makeCirculationActions(Actions& actions);
  void makeStrainActions(Actions& actions);
  void chooseStrainFile();
  void syncStrain();
  void takePerson();
  void syncSegments();
  bool segmentsWanted() const;
  /// Serves a movie; null where none are shown.
  std::function<presentation::SurfaceMap(double seconds)> segmentsOverTime(const StrainModel* strain,
                                                                           const Playback& playback) const;
  void makeValvesAction(Actions& actions);
  QString whyNoValves() const;
  void syncValves();
  void setSeeThrough(bool on);
  bool seesThrough() const;
  void slower();
  void addKey();
  void retractKey();
  void showImages();
  void reportMovieWritten(bool complete, const MoviePlan& plan);

  std::unique_ptr<Comparison> comparison_;
  std::unique_ptr<MovieRecorder> recorder_;
  std::unique_ptr<KeySequencePlayback> keySequence_;
  std::unique_ptr<CirculationModel> circulation_;
  std::unique_ptr<MeasuredMotion> measured_;
  std::unique_ptr<StrainModel> strain_;
  std::unique_ptr<StrainModel> secondStrain_; ///< Of the second view; null while there is none.
  QPointer<StrainPanel> strainPanel_;
  QAction* valves_ = nullptr;           ///< The window's.
  QString valvesTip_;                   ///< Tooltip of the action while it is enabled.
  QPointer<MotionDialog> seriesDialog_; ///< The window's.
  QPointer<ResidualTable> residuals_;
  QPointer<CirculationPanel> chart_;
  std::map<document::OrganId, double> throughOpacity_; ///< Of walls that were made opaque, before that.
  StatusLine* status_ = nullptr;
  JobQueue* secondJobs_ = nullptr;
  document::KeyId toldKey_; ///< The key about which the status bar shows a remark.
  QString keyRemark_;       ///< That remark; empty when it no longer applies.
  Subscription subscription_;
};

} // namespace viscera::app
