#pragma once

#include <QObject>

#include "window/timeline/volume_monitor.h"
#include "window/work/workspace.h"

class QLabel;
class QProgressBar;
class QStatusBar;

namespace viscera::app {

class ElidedLabel;

/// The status bar: the organ's volume and its change, the handles and how they are bound, the mode's hint,
/// and the task that runs.
class StatusLine final : public QObject {
  Q_OBJECT

public:
  StatusLine(Workspace& workspace, VolumeMonitor& volumes, QStatusBar* bar);

  void setHint(const QString& hint);
  /// Also shows the jobs of another queue, which has to live until it is unwatched.
  void watch(JobQueue& jobs);
  void unwatch(JobQueue& jobs);

private:
  void makeJob();
  void syncVolume();
  void syncBinding();
  void syncJobs();
  QString bindingText() const;
  QString bindingTip() const;

  Workspace& workspace_;
  QLabel* volume_;
  QLabel* binding_;
  ElidedLabel* hint_;
  QWidget* job_; ///< The task that runs: its step, how far it is, and a cross to cancel it.
  QLabel* step_;
  QProgressBar* progress_;
  struct Watched {
    JobQueue* jobs = nullptr;
    Subscription subscription;
  };
  std::vector<Watched> queues_;
  JobQueue* shownQueue_ = nullptr;
  std::int64_t shownJob_ = 0;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
