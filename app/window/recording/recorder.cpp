#include "window/recording/recorder.h"

#include <QFileInfo>

#include <algorithm>
#include <cmath>

#include "viscera/core/error.h"
#include "viscera/scene/movie_writer.h"
#include "viscera/session/volume_table.h"

namespace viscera::app {
namespace {

constexpr const char* kSlot = "record";
constexpr double kDrawingShare = 0.95; ///< Of the progress; the rest is closing the movie.
constexpr int kWaitMilliseconds = 5;   ///< When the writer is behind.
/// What is recorded of organs that do not move, s.
constexpr double kStillSeconds = 2;

/// Writes what comes through the channel. For the recorder's thread.
int writeFrames(const RecordingPlan& plan, int frames, FrameChannel& channel, Progress& progress) {
  const RecordingFormatInfo info = infoOf(plan.format);
  std::unique_ptr<scene::MovieWriter> writer;
  if (info.drawn) {
    std::filesystem::path target = plan.file.toStdString();
    if (plan.format == RecordingFormat::pictures)
      target /= ""; // A folder, whatever its name.
    writer = std::make_unique<scene::MovieWriter>(
        target, scene::MovieOptions{.framesPerSecond = plan.framesPerSecond});
  }
  int written = 0;
  while (auto frame = channel.next(progress)) {
    if (writer)
      writer->add(std::move(*frame));
    progress.report(kDrawingShare * ++written / frames);
  }
  if (writer) {
    Progress closing([&](double fraction, const std::string& step) {
      progress.report(kDrawingShare + (1 - kDrawingShare) * fraction, step);
    });
    progress.throwIfCancelled();
    writer->finish(closing);
  }
  if (plan.table || !info.drawn)
    session::writeVolumeTable((info.drawn ? plan.tableFile() : plan.file).toStdString(), channel.volumes());
  return written;
}

} // namespace

Recorder::Recorder(Workspace& workspace, QObject* parent)
    : QObject(parent), workspace_(workspace), jobs_([this](std::function<void()> work) {
        QMetaObject::invokeMethod(this, std::move(work), Qt::QueuedConnection);
      }) {
  slices_.setSingleShot(true);
  connect(&slices_, &QTimer::timeout, this, &Recorder::drawNext);
}

Recorder::~Recorder() {
  slices_.stop();
  if (channel_)
    channel_->fail();
}

bool Recorder::start(const RecordingPlan& plan, const std::vector<RecordingStage::Source>& sources) {
  if (running())
    return false;
  plan_ = plan;
  if (!workspace_.guarded([&] { prepare(sources); })) {
    stages_.clear();
    return false;
  }
  submit();
  slices_.start(0);
  Q_EMIT stateChanged();
  return true;
}

void Recorder::prepare(const std::vector<RecordingStage::Source>& sources) {
  stages_.clear();
  QSize size = plan_.size;
  // Both halves of two views, of even widths: some movies cannot have others.
  size.setWidth(size.width() / static_cast<int>(sources.size()) / 2 * 2);
  double seconds = 0;
  std::vector<std::string> names;
  for (const RecordingStage::Source& source : sources) {
    auto stage = std::make_unique<RecordingStage>(source);
    if (infoOf(plan_.format).drawn)
      stage->openWindow(source, size, plan_.caption);
    if (seconds == 0)
      seconds = plan_.cycles * stage->periodSeconds();
    for (const std::string& name : stage->names())
      names.push_back(sources.size() > 1 ? (stages_.empty() ? "A " : "B ") + name : name);
    stages_.push_back(std::move(stage));
  }
  // Slow motion is recorded as it is seen.
  const double speed = sources.front().playback.player().speed();
  if (seconds == 0)
    seconds = kStillSeconds;
  secondsAFrame_ = speed / plan_.framesPerSecond;
  frames_ = std::max(1, static_cast<int>(std::lround(seconds / secondsAFrame_)));
  drawn_ = 0;
  volumes_ = session::VolumeRecord(std::move(names));
}

void Recorder::submit() {
  channel_ = std::make_shared<FrameChannel>();
  const QString name = tr("Recording %1").arg(QFileInfo(plan_.file).fileName());
  jobs_.submit<int>(
      name.toStdString(), kSlot,
      [plan = plan_, frames = frames_, channel = channel_](Progress& progress) {
        return writeFrames(plan, frames, *channel, progress);
      },
      [this](const session::JobResult<int>& result) { end(result); });
}

void Recorder::cancel() {
  jobs_.cancelSlot(kSlot);
}

vtkSmartPointer<vtkImageData> Recorder::picture() {
  if (!infoOf(plan_.format).drawn)
    return nullptr;
  auto whole = stages_.front()->picture();
  for (std::size_t i = 1; i < stages_.size(); ++i)
    whole = besideEachOther(whole, stages_[i]->picture());
  return whole;
}

void Recorder::drawNext() {
  if (!running())
    return;
  if (!channel_->hasRoom())
    return slices_.start(kWaitMilliseconds);
  const bool done = workspace_.guarded([this] {
    const double seconds = drawn_ * secondsAFrame_;
    std::vector<double> row;
    for (const auto& stage : stages_) {
      stage->show(seconds);
      const std::vector<double> milliliters = stage->volumes();
      row.insert(row.end(), milliliters.begin(), milliliters.end());
    }
    if (!row.empty())
      volumes_.add(seconds, row);
    channel_->push(picture());
  });
  if (!done)
    return channel_->fail();
  if (++drawn_ < frames_)
    return slices_.start(0);
  channel_->close(volumes_);
}

void Recorder::end(const session::JobResult<int>& result) {
  slices_.stop();
  channel_.reset();
  stages_.clear();
  if (result.error)
    workspace_.report(*result.error);
  Q_EMIT stateChanged();
  Q_EMIT finished(result.value.has_value(), plan_);
}

} // namespace viscera::app
