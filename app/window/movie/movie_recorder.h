#pragma once

#include <QObject>

#include <memory>
#include <vector>

#include "viscera/core/job_queue.h"
#include "window/movie/movie_plan.h"
#include "window/movie/movie_stage.h"

namespace viscera::app {

/// Records a movie of one view, or of two side by side: a job on a thread of its own poses, draws off the
/// screen, encodes and writes, shows its progress and can be cancelled. What is cancelled or fails leaves
/// nothing behind.
class MovieRecorder final : public QObject {
  Q_OBJECT

public:
  /// `workspace` is told what went wrong.
  explicit MovieRecorder(Workspace& workspace, QObject* parent = nullptr);

  /// Starts; false when it cannot (and says why), or when one is being made.
  bool start(const MoviePlan& plan, const std::vector<MovieStage::Source>& sources);
  bool running() const { return running_; }
  void cancel();
  /// The jobs of the recorder, for the status bar.
  JobQueue& jobs() { return jobs_; }

Q_SIGNALS:
  void stateChanged();
  /// It ended: complete, or cancelled or failed with nothing left.
  void finished(bool complete, const viscera::app::MoviePlan& plan);

private:
  Workspace& workspace_;
  bool running_ = false;
  /// Last: it waits for its thread before anything else goes.
  JobQueue jobs_;

  void end(const JobResult<int>& result, const MoviePlan& plan);
};

} // namespace viscera::app
