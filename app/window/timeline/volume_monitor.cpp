#include "window/timeline/volume_monitor.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace viscera::app {
namespace {
constexpr int kUpdateMilliseconds = 100;
/// Rows kept: two minutes at 60 frames a second.
constexpr std::size_t kRows = 7200;
/// The last minute of drags.
constexpr std::size_t kDragRows = 600;
constexpr double kMillisecond = 1e-3;
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
      restart();
  });
  subscriptions_.push_back(workspace.onChange([this](const session::Change& change) {
    if (change.organs())
      rebuild();
    const bool moved = change.pose() && !change.rig() && !change.organs();
    if (moved || (dragging_ && !change.interactive))
      sampleDrag(change.interactive);
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
  record_ = session::VolumeRecord(names, kRows);
  drags_ = session::VolumeRecord(std::move(names), kDragRows);
  extremes_.clear();
  refresh();
  Q_EMIT linesChanged();
}

void VolumeMonitor::refresh() {
  // A line may outlive its organ for a moment: who plays may hear of a change before this observer does.
  for (Line& line : lines_)
    if (workspace_.document().organ(line.organ))
      line.nowMl = workspace_.live().volume(line.organ).nowMl;
}

void VolumeMonitor::restart() {
  record_.clear();
  extremes_.clear();
}

void VolumeMonitor::sample() {
  refresh();
  // Organs that are not bound yet stand still: that is no part of the beat.
  if (workspace_.live().busy())
    return;
  const session::Player& player = playback_.player();
  if (extremes_.size() != lines_.size() || player.ratePerMinute() != sampledRate_) {
    constexpr double kNothing = std::numeric_limits<double>::infinity();
    extremes_.assign(lines_.size(), {kNothing, -kNothing});
    sampledSince_ = player.playedSeconds();
    sampledRate_ = player.ratePerMinute();
  }
  std::vector<double> row;
  for (std::size_t line = 0; line < lines_.size(); ++line) {
    const double volume = lines_[line].nowMl;
    row.push_back(volume);
    extremes_[line] = {std::min(extremes_[line].low, volume), std::max(extremes_[line].high, volume)};
  }
  // The same instant again (another mode, another rate) is no news; a record that is given one begins anew.
  const bool again = record_.rows() > 0 && record_.seconds(record_.rows() - 1) == player.playedSeconds();
  if (!row.empty() && !again)
    record_.add(player.playedSeconds(), row);
  if (!throttle_.isActive())
    throttle_.start();
}

/// A row for the pose as it is now. What leads up to the first one is the pose before.
void VolumeMonitor::sampleDrag(bool goesOn) {
  const bool begins = goesOn && !std::exchange(dragging_, goesOn);
  dragging_ = goesOn;
  if (goesOn && !begins && sinceDragged_.elapsed() < kUpdateMilliseconds)
    return;
  const double step = kMillisecond * kUpdateMilliseconds;
  const double passed =
      begins || !sinceDragged_.isValid() ? step : kMillisecond * static_cast<double>(sinceDragged_.elapsed());
  const double last = drags_.rows() > 0 ? drags_.seconds(drags_.rows() - 1) : 0.0;
  std::vector<double> row;
  for (const Line& line : lines_)
    row.push_back(line.nowMl);
  if (row.empty())
    return;
  if (drags_.rows() == 0)
    drags_.add(0, row);
  refresh();
  for (std::size_t line = 0; line < lines_.size(); ++line)
    row[line] = lines_[line].nowMl;
  // Who holds still for a while does not stretch the chart.
  drags_.add(last + std::clamp(passed, 0.2 * step, 2 * step), row);
  sinceDragged_.start();
  if (!throttle_.isActive())
    throttle_.start();
}

bool VolumeMonitor::beatSeen() const {
  const session::Player& player = playback_.player();
  return !extremes_.empty() && player.playedSeconds() - sampledSince_ >= player.periodSeconds();
}

std::optional<scene::ValueRange> VolumeMonitor::range(std::size_t line) const {
  if (!beatSeen())
    return std::nullopt;
  return extremes_[line];
}

std::optional<session::CardiacIndices> VolumeMonitor::indices(std::size_t line) const {
  if (!lines_[line].cavity || !beatSeen())
    return std::nullopt;
  return session::cardiacIndices({extremes_[line].low, extremes_[line].high}, sampledRate_);
}

} // namespace viscera::app
