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
/// A slow computer meets the extremes of a beat only after several of them.
constexpr std::size_t kFewestInstants = 10;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr scene::ValueRange kNothing{kInfinity, -kInfinity};
} // namespace

VolumeMonitor::VolumeMonitor(Workspace& workspace, Playback& playback, QObject* parent) : QObject(parent) {
  throttle_.setSingleShot(true);
  throttle_.setInterval(kUpdateMilliseconds);
  connect(&throttle_, &QTimer::timeout, this, [this] {
    refresh();
    Q_EMIT updated();
  });
  connect(&playback, &Playback::advanced, this, &VolumeMonitor::sample);
  connect(&playback, &Playback::stateChanged, this, [this] {
    if (!sides_[0].playback->showing())
      restart();
  });
  sides_[0].workspace = &workspace;
  sides_[0].playback = &playback;
  watch(sides_[0]);
  rebuild();
}

void VolumeMonitor::setSecond(Workspace* workspace, Playback* playback) {
  sides_[1] = {workspace, playback, 0, 0, {}};
  if (workspace)
    watch(sides_[1]);
  rebuild();
}

void VolumeMonitor::watch(Side& side) {
  const bool first = &side == &sides_[0];
  side.subscriptions.push_back(side.workspace->onChange([this, first](const document::Change& change) {
    if (change.organs())
      rebuild();
    if (change.rig() || change.system()) // What was recorded is of other bindings.
      restart();
    const bool moved = change.pose() && !change.rig() && !change.organs();
    if (first && (moved || (dragging_ && !change.interactive)))
      sampleDrag(change.interactive);
  }));
  side.subscriptions.push_back(side.workspace->live().onEvent([this](const live::LiveEvent&) {
    if (!throttle_.isActive())
      throttle_.start();
  }));
}

std::vector<VolumeMonitor::Line> VolumeMonitor::linesOf(int side) const {
  std::vector<Line> lines;
  if (!sides_[side].workspace)
    return lines;
  for (const auto& organ : sides_[side].workspace->document().organs()) {
    if (!organ->look.tracked || !organ->closed())
      continue;
    const double rest = organ->restVolumeMm3 / kMm3PerMl;
    lines.push_back({organ->id, side, text(organ->name), organ->look.color, static_cast<bool>(organ->parent),
                     rest, rest});
  }
  return lines;
}

void VolumeMonitor::rebuild() {
  std::vector<Line> lines = linesOf(0);
  const std::vector<Line> second = linesOf(1);
  lines.insert(lines.end(), second.begin(), second.end());
  const auto same = [](const Line& a, const Line& b) {
    return a.organ == b.organ && a.side == b.side && a.name == b.name && a.color == b.color;
  };
  if (std::equal(lines.begin(), lines.end(), lines_.begin(), lines_.end(), same))
    return;
  lines_ = std::move(lines);
  std::vector<std::string> names;
  for (const Line& line : lines_)
    names.push_back(line.name.toStdString());
  record_ = motion::VolumeRecord(names, kRows);
  drags_ = motion::VolumeRecord(std::move(names), kDragRows);
  cycles_.assign(lines_.size(), motion::CycleTrace());
  extremes_.clear();
  refresh();
  Q_EMIT linesChanged();
}

void VolumeMonitor::refresh() {
  // A line may outlive its organ for a moment: who plays may hear of a change before this observer does.
  for (Line& line : lines_) {
    Workspace& workspace = *sides_[line.side].workspace;
    if (workspace.document().organ(line.organ))
      line.nowMl = workspace.live().volume(line.organ).nowMl;
  }
}

void VolumeMonitor::restart() {
  record_.clear();
  extremes_.clear();
  for (motion::CycleTrace& cycle : cycles_)
    cycle.clear();
}

/// Another rate makes another beat of the organs on that side.
void VolumeMonitor::restartSidesWithNewRates() {
  const bool all = extremes_.size() != lines_.size();
  const double played = sides_[0].playback->player().playedSeconds();
  extremes_.resize(lines_.size(), kNothing);
  for (int index = 0; index < static_cast<int>(sides_.size()); ++index) {
    Side& side = sides_[index];
    side.since = std::min(side.since, played); // Somebody has gone to another instant: time begins anew.
    if (!side.playback || (!all && side.playback->player().ratePerMinute() == side.rate))
      continue;
    side.since = played;
    side.rate = side.playback->player().ratePerMinute();
    for (std::size_t line = 0; line < lines_.size(); ++line)
      if (lines_[line].side == index) {
        extremes_[line] = kNothing;
        cycles_[line].clear();
      }
  }
}

void VolumeMonitor::sample() {
  refresh();
  // Organs that are not bound yet stand still: that is no part of the beat.
  for (const Side& side : sides_)
    if (side.workspace && side.workspace->live().busy())
      return;
  restartSidesWithNewRates();
  const double seconds = sides_[0].playback->player().playedSeconds();
  std::vector<double> row;
  for (std::size_t line = 0; line < lines_.size(); ++line) {
    const double volume = lines_[line].nowMl;
    row.push_back(volume);
    extremes_[line] = {std::min(extremes_[line].low, volume), std::max(extremes_[line].high, volume)};
    if (playbackOf(line).showing())
      cycles_[line].add(playbackOf(line).player().fraction(), volume);
  }
  // The same instant again (another mode, another rate) is no news; a record that is given one begins anew.
  const bool again = record_.rows() > 0 && record_.seconds(record_.rows() - 1) == seconds;
  if (!row.empty() && !again)
    record_.add(seconds, row);
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

bool VolumeMonitor::beatSeen(std::size_t line) const {
  if (extremes_.empty() || !playbackOf(line).sequence())
    return false;
  const double played = sides_[0].playback->player().playedSeconds() - sides_[lines_[line].side].since;
  return played >= playbackOf(line).player().periodSeconds() && cycles_[line].seen() >= kFewestInstants;
}

std::optional<scene::ValueRange> VolumeMonitor::range(std::size_t line) const {
  if (!beatSeen(line))
    return std::nullopt;
  return extremes_[line];
}

std::optional<motion::CardiacIndices> VolumeMonitor::indices(std::size_t line) const {
  if (!lines_[line].cavity || !beatSeen(line))
    return std::nullopt;
  return motion::cardiacIndices({extremes_[line].low, extremes_[line].high}, sides_[lines_[line].side].rate);
}

} // namespace viscera::app
