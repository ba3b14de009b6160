#pragma once

#include <memory>

#include "window/actions.h"
#include "window/compare/comparison.h"
#include "window/modes/mode.h"
#include "window/recorded/recorded_motion.h"
#include "window/recording/recorder.h"
#include "window/timeline/volume_monitor.h"

namespace viscera::app {

class StatusLine;

/// Looking at sequences and teaching with them: the sequences to choose from, labels, looking through
/// walls, two views, and recording.
class PlayMode final : public Mode {
  Q_OBJECT

public:
  PlayMode(const ModeParts& parts, Actions& actions);
  ~PlayMode() override;

  std::vector<const char*> actions() const override;
  QWidget* makePage(const Actions& actions) override;
  presentation::Shown shown() const override { return {}; }
  motion::WantedPose pose() const override { return motion::WantedPose::sequence; }
  UsefulPanels panels() const override { return {false, true, true}; }
  void setTheme(const Theme& theme) override { comparison_->setTheme(theme); }
  /// Shows what is recorded and what the second view does in the status bar.
  void setStatus(StatusLine& status);

  Comparison& comparison() { return *comparison_; }
  Recorder& recorder() { return *recorder_; }
  RecordedMotion& recorded() { return *recorded_; }

  /// Shows a sequence: on the organ that is there when it has it, else on its sample organ.
  void chooseSequence(const QString& id);
  /// Records what the view, or both views, show.
  bool record(const RecordingPlan& plan);

private:
  void makeMotionActions(Actions& actions);
  void makeComparisonActions(Actions& actions);
  void makeLookActions(Actions& actions);
  void setSeeThrough(bool on);
  bool seesThrough() const;
  void slower();
  void addKey();
  void sayRecorded(bool complete, const RecordingPlan& plan);

  std::unique_ptr<Comparison> comparison_;
  std::unique_ptr<Recorder> recorder_;
  std::unique_ptr<RecordedMotion> recorded_;
  StatusLine* status_ = nullptr;
  JobQueue* secondJobs_ = nullptr;
};

} // namespace viscera::app
