#pragma once

#include <QObject>

#include <functional>
#include <memory>

#include "window/actions.h"
#include "window/compare/comparison.h"
#include "window/recorded/recorded_motion.h"
#include "window/recording/recorder.h"
#include "window/sample_loader.h"
#include "window/settings.h"
#include "window/style/theme.h"
#include "window/timeline/playback.h"
#include "window/timeline/volume_monitor.h"
#include "window/view/label_scene.h"
#include "window/view/view_area.h"
#include "window/workspace.h"

namespace viscera::app {

class HandleScene;
class PlayPage;
class StatusLine;
class TimelineBar;
class VolumePanel;

/// What belongs to Play mode and its teaching: the sequences to choose from, labels, looking through walls,
/// two views, and recording; with their actions. The window only says where they stand.
class PlayParts final : public QObject {
  Q_OBJECT

public:
  /// The window's parts; all have to live longer.
  struct Window {
    Workspace& workspace;
    Playback& playback;
    VolumeMonitor& volumes;
    SampleLoader& samples;
    OrganScene& organs;
    HandleScene& handles;
    ViewArea& area;
    Settings& settings;
  };

  explicit PlayParts(const Window& window);
  ~PlayParts() override;

  /// Adds the actions of Play mode.
  void makeActions(Actions& actions);
  /// The ids of those actions for a menu, "" for a line between them.
  static std::vector<const char*> menu();
  PlayPage* makePage(const Actions& actions);
  /// Connects timeline, chart and status bar.
  void connectPanels(TimelineBar& timeline, VolumePanel& chart, StatusLine& status);
  void setTheme(const Theme& theme);

  Comparison& comparison() { return *comparison_; }
  Recorder& recorder() { return *recorder_; }
  RecordedMotion& recorded() { return *recorded_; }
  const LabelScene& labels() const { return *labels_; }

  /// Shows a sequence: on the organ that is there when it has it, else on its sample organ.
  void chooseSequence(const QString& id);
  /// Records what the view, or both views, show.
  bool record(const RecordingPlan& plan);

private:
  void makeLookActions(Actions& actions);
  void syncLookActions();
  void setSeeThrough(bool on);
  bool seesThrough() const;
  void slower();
  void addKey();
  void sayRecorded(bool complete, const RecordingPlan& plan);

  Window window_;
  std::unique_ptr<LabelScene> labels_;
  std::unique_ptr<Comparison> comparison_;
  std::unique_ptr<Recorder> recorder_;
  std::unique_ptr<RecordedMotion> recorded_;
  const Actions* actions_ = nullptr;
  VolumePanel* chart_ = nullptr;
  StatusLine* status_ = nullptr;
  JobQueue* secondJobs_ = nullptr;
  Subscription subscription_;
};

} // namespace viscera::app
