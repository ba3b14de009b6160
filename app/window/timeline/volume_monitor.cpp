#include "window/timeline/volume_monitor.h"

#include <algorithm>
#include <limits>

namespace viscera::app {
namespace {
constexpr int kUpdateMilliseconds = 100;
/// Rows kept: two minutes at 60 frames a second.
constexpr std::size_t kRows = 7200;
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
