#pragma once

#include <QObject>

#include <memory>
#include <vector>

#include "signs/movie_signs.h"
#include "viscera/core/job_queue.h"
#include "window/movie/movie_plan.h"
#include "window/movie/movie_stage.h"

namespace viscera::app {

/// Records a movie of one view, or of two side by side, above the signs of a beating heart: a job on a thread
/// of its own poses, draws off the screen, encodes and writes, shows its progress and can be cancelled. A
/// recording that is cancelled or fails leaves no file.
class MovieRecorder final : public QObject {
  Q_OBJECT

public:
  /// Errors are reported to `workspace`.
  explicit MovieRecorder(Workspace& workspace, QObject* parent = nullptr);

  /// Starts recording, with `signs` (may be null) below the views; false when that is not possible (a message
  /// gives the reason), or while another movie is recorded.
  bool start(const MoviePlan& plan, const std::vector<MovieStage::Source>& sources,
             std::unique_ptr<MovieSigns> signs);
  bool running() const { return running_; }
  void cancel();
  /// The jobs of the recorder, for the status bar.
  JobQueue& jobs() { return jobs_; }

Q_SIGNALS:
  void stateChanged();
  /// The recording ended: complete, or cancelled or failed without a file.
  void finished(bool complete, const viscera::app::MoviePlan& plan);

private:
  Workspace& workspace_;
  bool running_ = false;
  /// The last member, so that its thread ends before other members are destroyed.
  JobQueue jobs_;

  void end(const JobResult<int>& result, const MoviePlan& plan);
};

} // namespace viscera::app
