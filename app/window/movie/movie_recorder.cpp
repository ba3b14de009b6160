#include "window/movie/movie_recorder.h"

#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <utility>

#include "viscera/anatomy/part.h"
#include "viscera/core/error.h"
#include "viscera/scene/movie_writer.h"
#include "viscera/sequences/volume_record.h"
#include "window/work/heap.h"
#include "window/work/mailbox.h"

namespace viscera::app {
namespace {

constexpr const char* kRecordSlot = "record";
constexpr double kDrawingShare = 0.95; ///< Of the progress; the rest is closing the movie.
/// Duration of a movie of organs that do not move, s.
constexpr double kStillSeconds = 2;

/// The data passed to the recording thread, none of which belong to the window.
struct Take {
  MoviePlan plan;
  std::vector<std::unique_ptr<MovieStage>> stages;
  std::unique_ptr<MovieSigns> signs; ///< Below the stages; may be null.
  std::vector<std::string> names;    ///< Of the tracked volumes of all stages.
  double secondsAFrame = 0;
  int frames = 0;
};

/// The views as they are now. For the main thread.
Take prepare(const MoviePlan& plan, const std::vector<MovieStage::Source>& sources,
             std::unique_ptr<MovieSigns> signs) {
  Take take{plan, {}, std::move(signs), {}, 0, 0};
  QSize size = plan.size;
  if (take.signs)
    size.setHeight(size.height() - take.signs->height());
  // Both halves of two views, of even widths: some movies cannot have others.
  size.setWidth(size.width() / static_cast<int>(sources.size()) / 2 * 2);
  double seconds = 0;
  for (const MovieStage::Source& source : sources) {
    auto stage = std::make_unique<MovieStage>(source, size, plan.caption);
    if (seconds == 0)
      seconds = plan.cycles * stage->periodSeconds();
    for (const std::string& name : stage->names())
      take.names.push_back(sources.size() > 1 ? (take.stages.empty() ? "A " : "B ") + name : name);
    take.stages.push_back(std::move(stage));
  }
  if (seconds == 0)
    seconds = kStillSeconds;
  // Slow motion is recorded as it is seen.
  take.secondsAFrame = sources.front().playback.player().speed() / plan.framesPerSecond;
  take.frames = std::max(1, static_cast<int>(std::lround(seconds / take.secondsAFrame)));
  return take;
}

std::unique_ptr<scene::MovieWriter> openMovie(const MoviePlan& plan) {
  if (!infoOf(plan.format).drawn)
    return nullptr;
  std::filesystem::path target = plan.file.toStdString();
  if (plan.format == MovieFormat::pictures)
    target /= ""; // A folder, whatever its name.
  return std::make_unique<scene::MovieWriter>(target,
                                              scene::MovieOptions{.framesPerSecond = plan.framesPerSecond});
}

vtkSmartPointer<vtkImageData> frameOf(const Take& take, double seconds) {
  auto whole = take.stages.front()->picture();
  for (std::size_t i = 1; i < take.stages.size(); ++i)
    whole = besideEachOther(whole, take.stages[i]->picture());
  if (!take.signs)
    return whole;
  const double period = take.stages.front()->periodSeconds();
  return aboveEachOther(whole, take.signs->picture(period > 0 ? std::fmod(seconds, period) / period : 0));
}

/// The volumes of all stages at one time.
std::vector<double> showAt(const Take& take, double seconds) {
  std::vector<double> row;
  for (const auto& stage : take.stages) {
    const std::vector<double>& milliliters = stage->show(seconds);
    row.insert(row.end(), milliliters.begin(), milliliters.end());
  }
  return row;
}

/// Poses, draws and writes every frame. For the recording thread, which the stages' windows belong to: they
/// go when this returns or throws.
int record(Take take, Progress& progress) {
  const auto writer = openMovie(take.plan);
  sequences::VolumeRecord volumes(take.names);
  for (int frame = 0; frame < take.frames; ++frame) {
    progress.throwIfCancelled();
    const double seconds = frame * take.secondsAFrame;
    if (const std::vector<double> row = showAt(take, seconds); !row.empty())
      volumes.add(seconds, row);
    if (writer)
      writer->add(frameOf(take, seconds));
    progress.report(kDrawingShare * (frame + 1) / take.frames);
  }
  if (writer) {
    Progress closing([&](double fraction, const Text& step) {
      progress.report(kDrawingShare + (1 - kDrawingShare) * fraction, step);
    });
    progress.throwIfCancelled();
    writer->finish(closing);
  }
  if (take.plan.table || !writer)
    sequences::writeVolumeTable((writer ? take.plan.tableFile() : take.plan.file).toStdString(), volumes,
                                anatomy::chamberKeys(volumes.names()));
  return take.frames;
}

} // namespace

MovieRecorder::MovieRecorder(Workspace& workspace, QObject* parent)
    : QObject(parent), workspace_(workspace), jobs_(mailbox()) {}

bool MovieRecorder::start(const MoviePlan& plan, const std::vector<MovieStage::Source>& sources,
                          std::unique_ptr<MovieSigns> signs) {
  if (running_)
    return false;
  auto take = std::make_shared<Take>();
  if (!workspace_.guarded([&] { *take = prepare(plan, sources, std::move(signs)); }))
    return false;
  running_ = true;
  jobs_.submit<int>(
      tr("Recording %1").arg(QFileInfo(plan.file).fileName()).toStdString(), kRecordSlot,
      [take](Progress& progress) { return record(std::move(*take), progress); },
      [this, plan](const JobResult<int>& result) { end(result, plan); });
  Q_EMIT stateChanged();
  return true;
}

void MovieRecorder::cancel() {
  jobs_.cancelSlot(kRecordSlot);
}

void MovieRecorder::end(const JobResult<int>& result, const MoviePlan& plan) {
  running_ = false;
  returnFreedMemory();
  if (result.error)
    workspace_.report(*result.error);
  Q_EMIT stateChanged();
  Q_EMIT finished(result.value.has_value(), plan);
}

} // namespace viscera::app
