#include "window/timeline/volume_monitor.h"

#include <algorithm>

namespace viscera::app {
namespace {
constexpr int kUpdateMilliseconds = 100;
/// Rows kept: two minutes at 60 frames a second.
constexpr std::size_t kRows = 7200;
/// The extremes are looked for in so many of the last beats: frames do not meet them in every beat.
constexpr double kBeats = 5;
} // namespace

VolumeMonitor::VolumeMonitor(Workspace& workspace, Playback& playback, QObject* parent)
    : QObject(parent), workspace_(workspace), playback_(playback) {
  throttle_.setSingleShot(true);
  throttle_.setInterval(kUpdateMilliseconds);
  connect(&throttle_, &QTimer::timeout, this, [this] {
    refresh();
    Q_EMIT updated();
  });
  connect(&playback, &Playback::advanced, this, &VolumeMonitor::sample);
  connect(&playback, &Playback::stateChanged, this, [this] {
    if (!playback_.showing())
      record_.clear();
  });
  subscriptions_.push_back(workspace.onChange([this](const session::Change& change) {
    if (change.organs())
      rebuild();
  }));
  subscriptions_.push_back(workspace.live().onEvent([this](const session::LiveEvent&) {
    if (!throttle_.isActive())
      throttle_.start();
  }));
  rebuild();
}

void VolumeMonitor::rebuild() {
  std::vector<Line> lines;
  std::vector<std::string> names;
  for (const auto& organ : workspace_.document().organs()) {
    if (!organ->look.tracked || !organ->closed())
      continue;
    lines.push_back({organ->id, text(organ->name), organ->look.color, static_cast<bool>(organ->parent),
                     organ->restVolumeMm3 / kMm3PerMl, organ->restVolumeMm3 / kMm3PerMl});
    names.push_back(organ->name);
  }
  const auto same = [](const Line& a, const Line& b) {
    return a.organ == b.organ && a.name == b.name && a.color == b.color;
  };
  if (std::equal(lines.begin(), lines.end(), lines_.begin(), lines_.end(), same))
    return;
  lines_ = std::move(lines);
  record_ = session::VolumeRecord(std::move(names), kRows);
  refresh();
  Q_EMIT linesChanged();
}

void VolumeMonitor::refresh() {
  // A line may outlive its organ for a moment: who plays may hear of a change before this observer does.
  for (Line& line : lines_)
    if (workspace_.document().organ(line.organ))
      line.nowMl = workspace_.live().volume(line.organ).nowMl;
}

void VolumeMonitor::sample() {
  refresh();
  std::vector<double> row;
  for (const Line& line : lines_)
    row.push_back(line.nowMl);
  if (!row.empty())
    record_.add(playback_.player().playedSeconds(), row);
  if (!throttle_.isActive())
    throttle_.start();
}

std::vector<double> VolumeMonitor::lastBeats(std::size_t line) const {
  const double period = playback_.player().periodSeconds();
  const std::size_t rows = record_.rows();
  if (rows < 2 || period <= 0)
    return {};
  const double last = record_.seconds(rows - 1);
  if (last - record_.seconds(0) < period)
    return {};
  return record_.column(line, last - kBeats * period);
}

std::optional<scene::ValueRange> VolumeMonitor::range(std::size_t line) const {
  const std::vector<double> volumes = lastBeats(line);
  if (volumes.empty())
    return std::nullopt;
  const auto [low, high] = std::minmax_element(volumes.begin(), volumes.end());
  return scene::ValueRange{*low, *high};
}

std::optional<session::CardiacIndices> VolumeMonitor::indices(std::size_t line) const {
  const std::vector<double> volumes = lastBeats(line);
  if (!lines_[line].cavity || volumes.empty())
    return std::nullopt;
  return session::cardiacIndices(volumes, playback_.player().ratePerMinute());
}

} // namespace viscera::app
