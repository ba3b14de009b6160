#include "window/timeline/status_line.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QStatusBar>
#include <QToolButton>

#include "viscera/presentation/presenter.h"
#include "window/style/language.h"
#include "window/widgets/elided_label.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {
/// Logical pixels: what a long name of a file may take.
constexpr int kJobWidth = 360;
/// Less of a hint says nothing.
constexpr int kFewestHintLetters = 20;
} // namespace

StatusLine::StatusLine(Workspace& workspace, VolumeMonitor& volumes, QStatusBar* bar)
    : QObject(bar), workspace_(workspace), volume_(new QLabel(bar)), binding_(new QLabel(bar)),
      hint_(new ElidedLabel(bar)), job_(new QWidget(bar)), step_(new QLabel(job_)),
      progress_(new QProgressBar(job_)) {
  bar->setSizeGripEnabled(false);
  volume_->setObjectName(QStringLiteral("statusVolume"));
  binding_->setObjectName(QStringLiteral("statusBinding"));
  hint_->setObjectName(QStringLiteral("muted"));
  hint_->setFewestLetters(kFewestHintLetters);
  volume_->setContentsMargins(8, 0, 12, 0);
  binding_->setContentsMargins(0, 0, 12, 0);
  bar->addWidget(volume_);
  bar->addWidget(binding_);
  bar->addWidget(hint_, 1);
  makeJob();
  bar->addPermanentWidget(job_);
  connect(&volumes, &VolumeMonitor::shown, this, &StatusLine::syncVolume);
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.organs()) // After a change of the pose, volumes are updated together with those of the list
                         // and the chart.
      syncVolume();
    syncBinding();
  }));
  subscriptions_.push_back(workspace.selection().onChange([this] { syncVolume(); }));
  subscriptions_.push_back(workspace.live().onEvent([this](const live::LiveEvent& event) {
    if (event.status || workspace_.warp().map())
      syncBinding();
  }));
  subscriptions_.push_back(workspace.warp().onChange([this] { syncBinding(); }));
  watch(workspace.jobs());
  syncVolume();
  syncBinding();
}

void StatusLine::makeJob() {
  auto* row = makeLayout<QHBoxLayout>(job_, 8, {0, 0, 4, 0});
  step_->setObjectName(QStringLiteral("jobStep"));
  progress_->setTextVisible(false);
  progress_->setFixedWidth(120);
  auto* cancel = makeIconButton("close", tr("Cancel this task"), job_, 12);
  cancel->setObjectName(QStringLiteral("cancelJob"));
  row->addWidget(step_);
  row->addWidget(progress_);
  row->addWidget(cancel);
  connect(cancel, &QToolButton::clicked, this, [this] {
    if (shownQueue_)
      shownQueue_->cancel(shownJob_);
  });
  job_->hide();
}

void StatusLine::setHint(const QString& hint) {
  hint_->setFullText(hint);
}

void StatusLine::syncVolume() {
  const auto organ = workspace_.describedOrgan();
  if (!organ) {
    const auto count = static_cast<int>(workspace_.document().organs().size());
    volume_->setToolTip({});
    return volume_->setText(count == 0 ? tr("No organ") : tr("%n organs", nullptr, count));
  }
  const live::OrganVolume volume = workspace_.live().volume(organ->id);
  const QString whole = inWords(presentation::labelOf(*organ));
  const QString name = shortenedName(whole, *volume_);
  volume_->setToolTip(name == whole ? QString() : whole);
  if (!volume.closed)
    return volume_->setText(tr("%1: open surface, no volume").arg(name));
  QString line =
      tr("%1  %2  (%3, %4)")
          .arg(name, formatMilliliters(volume.nowMl), formatChange(volume), formatRelativeChange(volume));
  if (organ->volumeLocked)
    line += tr("  locked");
  volume_->setText(line);
}

QString StatusLine::bindingText() const {
  const std::size_t handles = workspace_.document().rig().handles.size();
  if (handles == 0)
    return tr("no handles");
  const QString line = tr("%n handles", nullptr, static_cast<int>(handles));
  for (const auto& organ : workspace_.document().organs()) {
    const live::BindingStatus status = workspace_.live().status(organ->id);
    switch (status.state) {
    case live::BindingStatus::State::binding:
      return line + tr(", binding...");
    case live::BindingStatus::State::failed:
      return line + tr(", %1 not bound").arg(inWords(presentation::labelOf(*organ)));
    case live::BindingStatus::State::stale:
      return line + tr(", binding cancelled");
    case live::BindingStatus::State::unbound:
      return line;
    case live::BindingStatus::State::bound:
      break;
    }
  }
  return line;
}

/// How the handles move the organs, for who asks.
QString StatusLine::bindingTip() const {
  const std::string& id = workspace_.document().system().id;
  if (workspace_.document().rig().handles.empty() || !workspace_.registry().contains(id))
    return {};
  QString tip = inWords(workspace_.registry().find(id)->name());
  double seconds = 0;
  for (const auto& organ : workspace_.document().organs()) {
    const live::BindingStatus status = workspace_.live().status(organ->id);
    if (status.state != live::BindingStatus::State::bound)
      return tip;
    seconds += status.report.seconds;
  }
  return tip + tr(", bound in %1 ms").arg(formatNumber(1000 * seconds, seconds < 0.01 ? 1 : 0));
}

void StatusLine::syncBinding() {
  binding_->setToolTip(bindingTip());
  const double folded = workspace_.warp().foldedMl();
  binding_->setText(
      folded > 0 ? tr("%1, %2 of tissue folded by the pose").arg(bindingText(), formatMilliliters(folded))
                 : bindingText());
}

void StatusLine::watch(JobQueue& jobs) {
  queues_.push_back({&jobs, jobs.onChange([this] { syncJobs(); })});
}

void StatusLine::unwatch(JobQueue& jobs) {
  std::erase_if(queues_, [&](const Watched& watched) { return watched.jobs == &jobs; });
  syncJobs();
}

void StatusLine::syncJobs() {
  for (const Watched& watched : queues_)
    for (const JobInfo& job : watched.jobs->jobs()) {
      if (!job.running)
        continue;
      shownQueue_ = watched.jobs;
      shownJob_ = job.id;
      const QString said =
          job.step.empty() ? inWords(job.name) : tr("%1: %2").arg(inWords(job.name), inWords(job.step));
      step_->setText(step_->fontMetrics().elidedText(said, Qt::ElideMiddle, kJobWidth));
      step_->setToolTip(said);
      progress_->setRange(0, job.fraction > 0 ? 1000 : 0); // A range of 0 to 0 shows that the progress is
                                                           // unknown.
      progress_->setValue(static_cast<int>(1000 * job.fraction));
      return job_->show();
    }
  shownQueue_ = nullptr;
  shownJob_ = 0;
  job_->hide();
}

} // namespace viscera::app
