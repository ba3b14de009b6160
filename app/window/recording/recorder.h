#pragma once

#include <QObject>
#include <QTimer>

#include <memory>
#include <vector>

#include "viscera/session/job_queue.h"
#include "viscera/session/volume_record.h"
#include "window/recording/frame_channel.h"
#include "window/recording/recording_plan.h"
#include "window/recording/recording_stage.h"

namespace viscera::app {

/// Records one view, or two side by side. Frames are drawn off the screen between the window's own events,
/// one at a time; encoding and writing is a job on a thread of its own that shows its progress and can be
/// cancelled. What is cancelled or fails leaves nothing behind.
class Recorder final : public QObject {
  Q_OBJECT

public:
  /// `workspace` is told what went wrong.
  explicit Recorder(Workspace& workspace, QObject* parent = nullptr);
  ~Recorder() override;

  /// Starts; false when it cannot (and says why), or when one is being made.
  bool start(const RecordingPlan& plan, const std::vector<RecordingStage::Source>& sources);
  bool running() const { return channel_ != nullptr; }
  void cancel();
  /// The jobs of the recorder, for the status bar.
  session::JobQueue& jobs() { return jobs_; }

Q_SIGNALS:
  void stateChanged();
  /// It ended: complete, or cancelled or failed with nothing left.
  void finished(bool complete, const viscera::app::RecordingPlan& plan);

private:
  void prepare(const std::vector<RecordingStage::Source>& sources);
  void submit();
  void drawNext();
  vtkSmartPointer<vtkImageData> picture();
  void end(const session::JobResult<int>& result);

  Workspace& workspace_;
  session::JobQueue jobs_;
  RecordingPlan plan_;
  std::vector<std::unique_ptr<RecordingStage>> stages_;
  std::shared_ptr<FrameChannel> channel_;
  session::VolumeRecord volumes_;
  double secondsAFrame_ = 0;
  int frames_ = 0;
  int drawn_ = 0;
  QTimer slices_;
};

} // namespace viscera::app
