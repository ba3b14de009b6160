#include "window/timeline/volume_monitor.h"

#include <algorithm>
#include <utility>

#include <QPointer>

#include "viscera/anatomy/part.h"
#include "viscera/core/background.h"
#include "viscera/presentation/presenter.h"
#include "window/style/language.h"
#include "window/timeline/measured_motion.h"

namespace viscera::app {
namespace {
constexpr int kVolumeUpdateMilliseconds = 100;
/// Rows kept: two minutes at 60 frames a second.
constexpr std::size_t kRows = 7200;
/// The last minute of drags.
constexpr std::size_t kDragRows = 600;
constexpr double kMillisecond = 1e-3;
const char* const kCycleSlot = "cycle";

bool isCharted(const document::Organ& organ) {
  return organ.look.tracked && organ.look.visible && organ.closed();
}

/// The cycle is measured so much later where no sequence is seen: its numbers are not urgent, and a drag that
/// begins under a lock just set is.
constexpr int kUnseenDelayMilliseconds = 500;
} // namespace

VolumeMonitor::VolumeMonitor(Workspace& workspace, Playback& playback, QObject* parent) : QObject(parent) {
  throttle_.setSingleShot(true);
  throttle_.setInterval(kVolumeUpdateMilliseconds);
  connect(&throttle_, &QTimer::timeout, this, &VolumeMonitor::update);
  frame_.setSingleShot(true);
  connect(&frame_, &QTimer::timeout, this, &VolumeMonitor::followFrame);
  measureSoon_.setSingleShot(true);
  connect(&measureSoon_, &QTimer::timeout, this, &VolumeMonitor::measureCycles);
  connect(&playback, &Playback::advanced, this, &VolumeMonitor::sample);
  connect(&playback, &Playback::stateChanged, this, [this] {
    if (!sides_[0].playback->showing())
      record_.clear();
  });
  sides_[0].workspace = &workspace;
  sides_[0].playback = &playback;
  watch(sides_[0]);
  rebuild();
}

void VolumeMonitor::setSecond(Workspace* workspace, Playback* playback) {
  sides_[1] = {workspace, playback, {}, {}, {}};
  ++cycles_;
  if (workspace)
    watch(sides_[1]);
  rebuild();
}

void VolumeMonitor::setMeasured(const MeasuredMotion& measured) {
  measured_ = &measured;
  connect(&measured, &MeasuredMotion::changed, this, &VolumeMonitor::update);
}

void VolumeMonitor::watch(Side& side) {
  const bool first = &side == &sides_[0];
  side.subscriptions.push_back(side.workspace->onChange([this, first, &side](const document::Change& change) {
    if (change.organs())
      rebuild();
    if (change.rig() || change.system()) // What was recorded is of other bindings.
      record_.clear();
    measureSoon(side);
    const bool moved = change.pose() && !change.rig() && !change.organs();
    const bool released = first && dragging_ && !change.interactive;
    if (first && (moved || released))
      sampleDrag(change.interactive);
    if (released || (change.pose() && !change.interactive)) // At the end of a drag numbers are updated at
                                                            // once.
      sides_[first ? 0 : 1].workspace->afterChange([this] { update(); });
  }));
  side.subscriptions.push_back(side.workspace->selection().onChange([this] {
    rebuild();
    Q_EMIT chosenChanged();
  }));
  side.subscriptions.push_back(side.workspace->live().onEvent([this, &side](const live::LiveEvent& event) {
    if (event.status)
      measureSoon(side);
    // Once for all organs of a frame; while organs are bound one after the other, updates are throttled.
    const bool oneOfMany = event.status && side.workspace->live().busy();
    if ((event.moved || event.replaced) && !oneOfMany)
      frame_.start();
    if (!throttle_.isActive())
      throttle_.start();
  }));
  connect(side.playback, &Playback::stateChanged, this, [this, &side] { measureSoon(side); });
  measureSoon_.start(0);
}

std::set<document::OrganId> VolumeMonitor::chartedIn(Workspace& workspace) {
  std::vector<const document::Organ*> whole;
  for (const auto& organ : workspace.document().organs())
    if (isCharted(*organ) && !organ->parent)
      whole.push_back(organ.get());
  const auto chosen = workspace.document().organ(workspace.selection().organ());
  const document::OrganId first = !chosen          ? document::OrganId{}
                                  : chosen->parent ? chosen->parent
                                                   : chosen->id;
  std::stable_sort(whole.begin(), whole.end(), [first](const auto* a, const auto* b) {
    return std::pair(a->id == first, a->restVolumeMm3) > std::pair(b->id == first, b->restVolumeMm3);
  });
  std::set<document::OrganId> ids;
  for (std::size_t i = 0; i < std::min(kMostLines, whole.size()); ++i)
    ids.insert(whole[i]->id);
  return ids;
}

std::vector<VolumeMonitor::Line> VolumeMonitor::linesOf(int side) const {
  std::vector<Line> lines;
  if (!sides_[side].workspace)
    return lines;
  const document::Document& document = sides_[side].workspace->document();
  const std::set<document::OrganId> charted = chartedIn(*sides_[side].workspace);
  for (const auto& organ : document.organs()) {
    // A cavity of a wall that has no line, such as an open one, stands for itself.
    const auto wall = document.organ(organ->parent);
    const bool left = wall && isCharted(*wall) && charted.count(wall->id) == 0;
    if (!isCharted(*organ) || left || (!organ->parent && charted.count(organ->id) == 0))
      continue;
    const double rest = organ->restVolumeMm3 / kMm3PerMl;
    const std::string label = presentation::labelOf(*organ);
    lines.push_back({organ->id, side, inWords(label), presentation::shownColor(organ->look.color),
                     organ->parent || anatomy::chamberNamed(organ->name).has_value(), rest, rest, label});
  }
  return lines;
}

std::size_t VolumeMonitor::chosenLine() const {
  const document::OrganId chosen = sides_[0].workspace->selection().organ();
  const auto line = std::find_if(lines_.begin(), lines_.end(),
                                 [chosen](const Line& one) { return one.side == 0 && one.organ == chosen; });
  return static_cast<std::size_t>(line - lines_.begin());
}

void VolumeMonitor::rebuild() {
  std::vector<Line> lines = linesOf(0);
  const std::vector<Line> second = linesOf(1);
  lines.insert(lines.end(), second.begin(), second.end());
  std::ptrdiff_t charted = 0;
  for (const Side& side : sides_)
    if (side.workspace) {
      const document::OrganList& organs = side.workspace->document().organs();
      charted += std::count_if(organs.begin(), organs.end(), [](const auto& one) { return isCharted(*one); });
    }
  unlisted_ = static_cast<int>(charted - static_cast<std::ptrdiff_t>(lines.size()));
  const auto same = [](const Line& a, const Line& b) {
    return a.organ == b.organ && a.side == b.side && a.name == b.name && a.color == b.color;
  };
  if (std::equal(lines.begin(), lines.end(), lines_.begin(), lines_.end(), same))
    return;
  lines_ = std::move(lines);
  std::vector<std::string> names;
  for (const Line& line : lines_)
    names.push_back(line.label);
  record_ = sequences::VolumeRecord(names, kRows);
  drags_ = sequences::VolumeRecord(std::move(names), kDragRows);
  dragsBehind_ = false;
  refresh();
  Q_EMIT linesChanged();
}

void VolumeMonitor::refresh() {
  // A line may outlive its organ for a moment, because playback may be notified of a change before this
  // observer.
  for (Line& line : lines_) {
    Workspace& workspace = *sides_[line.side].workspace;
    if (workspace.document().organ(line.organ))
      line.nowMl = workspace.live().volume(line.organ).nowMl;
  }
}

/// List, status bar and chart are notified together, so that they show the same.
void VolumeMonitor::update() {
  throttle_.stop();
  followFrame();
  Q_EMIT updated();
}

/// Volumes in one loop over all organs take a millisecond or two, texts less.
void VolumeMonitor::followFrame() {
  frame_.stop();
  refresh();
  if (dragsBehind_ && posesAreSeen() && !sides_[0].workspace->live().busy()) {
    dragsBehind_ = false;
    if (drags_.rows() > 0)
      addDrag(false);
  }
  Q_EMIT shown();
}

void VolumeMonitor::measureSoon(const Side& side) {
  const bool seen = side.playback->wantedPose() == live::WantedPose::sequence;
  measureSoon_.start(seen ? 0 : kUnseenDelayMilliseconds);
}

void VolumeMonitor::measureCycles() {
  for (int side = 0; side < static_cast<int>(sides_.size()); ++side)
    if (sides_[side].workspace)
      measure(side);
}

void VolumeMonitor::measure(int index) {
  Side& side = sides_[index];
  Workspace& workspace = *side.workspace;
  const live::MotionRunner& runner = side.playback->player().runner();
  if (!side.playback->player().movable() || workspace.live().busy()) {
    workspace.jobs().cancelSlot(kCycleSlot);
    ++side.ticket;
    side.cause.reset();
    if (side.curves)
      ++cycles_;
    side.curves.reset();
    return;
  }
  const live::MotionCause cause = live::causeOf(runner);
  if (side.cause == cause)
    return;
  side.cause = cause;
  side.curves.reset();
  ++cycles_;
  auto work = [ahead =
                   std::make_shared<live::MotionCopy>(runner, workspace.live().copy())](Progress& progress) {
    // A lock that is set has the cycle measured anew, just when a drag under it begins.
    live::CycleCurves curves;
    inBackground([&] { curves = live::measureCycle(ahead->runner(), progress); });
    return curves;
  };
  auto done = [self = QPointer(this), index, mine = ++side.ticket](JobResult<live::CycleCurves> result) {
    if (!self || self->sides_[index].ticket != mine)
      return;
    Side& measured = self->sides_[index];
    if (result.cancelled()) // The next occasion measures again.
      measured.cause.reset();
    measured.curves = std::move(result.value);
    ++self->cycles_;
    if (result.error)
      measured.workspace->report(*result.error);
    Q_EMIT self->updated();
  };
  workspace.jobs().submit<live::CycleCurves>(tr("Volumes over the cycle").toStdString(), kCycleSlot,
                                             std::move(work), std::move(done));
}

void VolumeMonitor::sample() {
  followFrame();
  // Organs that are not bound yet stand still: that is no part of the beat.
  for (const Side& side : sides_)
    if (side.workspace && side.workspace->live().busy())
      return;
  const double seconds = sides_[0].playback->player().playedSeconds();
  std::vector<double> row;
  for (const Line& line : lines_)
    row.push_back(line.nowMl);
  // The same instant again (another mode, another rate) is not recorded, because the record would begin anew.
  const bool again = record_.rows() > 0 && record_.seconds(record_.rows() - 1) == seconds;
  if (!row.empty() && !again)
    record_.add(seconds, row);
  if (!throttle_.isActive())
    throttle_.start();
}

/// Whether the first view's organs are in the document's pose. This checks the displayed pose, because a
/// chosen sequence may not have been started, and one that undo has just removed may still be shown.
bool VolumeMonitor::posesAreSeen() const {
  const Points& seen = sides_[0].workspace->live().shownPose();
  const Points& own = sides_[0].workspace->document().pose();
  return seen.rows() == own.rows() && seen == own;
}

/// A row for the pose as it is now, where it is seen; else it comes later.
void VolumeMonitor::sampleDrag(bool goesOn) {
  const bool begins = goesOn && !std::exchange(dragging_, goesOn);
  dragging_ = goesOn;
  dragsBehind_ = !posesAreSeen();
  // Where a sequence is to be seen, a pose that is changed begins no chart of drags in the place of its
  // cycle.
  const Playback& playback = *sides_[0].playback;
  const bool beginsNone =
      drags_.rows() == 0 && playback.sequence() && playback.wantedPose() == live::WantedPose::sequence;
  if (dragsBehind_ || beginsNone)
    return;
  if (goesOn && !begins && sinceDragged_.elapsed() < kVolumeUpdateMilliseconds)
    return;
  addDrag(begins);
}

/// What leads up to the first row is the pose before.
void VolumeMonitor::addDrag(bool begins) {
  const double step = kMillisecond * kVolumeUpdateMilliseconds;
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
  // A pause within a drag does not stretch the chart.
  drags_.add(last + std::clamp(passed, 0.2 * step, 2 * step), row);
  sinceDragged_.start();
  if (!throttle_.isActive())
    throttle_.start();
}

QString VolumeMonitor::nameOf(const Line& line) const {
  return hasSecond() ? tr("%1: %2").arg(line.side + 1).arg(line.name) : line.name;
}

VolumeMonitor::Curve VolumeMonitor::cycle(std::size_t line) const {
  const Side& side = sides_[lines_[line].side];
  // A sequence may be gone before the next measurement begins: a session is opened while the heart beats.
  if (!side.curves || !side.playback->sequence())
    return {};
  const auto& organs = side.cause->organs;
  for (std::size_t organ = 0; organ < organs.size(); ++organ)
    if (std::get<document::OrganId>(organs[organ]) == lines_[line].organ)
      return {side.curves->fractions, side.curves->milliliters[organ]};
  return {};
}

std::optional<scene::ValueRange> VolumeMonitor::range(std::size_t line) const {
  const Curve curve = cycle(line);
  if (curve.milliliters.empty())
    return std::nullopt;
  const auto [low, high] = std::minmax_element(curve.milliliters.begin(), curve.milliliters.end());
  return scene::ValueRange{*low, *high};
}

bool VolumeMonitor::beats(std::size_t line) const {
  const sequences::Sequence* sequence = playbackOf(line).sequence();
  if (!sequence)
    return false;
  // A tracked motion is in the document as keys. The second view shows it if both views have the same
  // sequence.
  const bool measured =
      measured_ && measured_->surfaceOf(lines_[line].organ) && sequence == sides_[0].playback->sequence();
  return measured || sequence->heart() != nullptr;
}

std::vector<heart::NormalRange> VolumeMonitor::normals(std::size_t line,
                                                       const anatomy::Person& person) const {
  std::vector<heart::NormalRange> ranges = heart::normalRanges(lines_[line].label, person);
  if (!beats(line))
    std::erase_if(ranges, [](const heart::NormalRange& range) {
      return range.quantity != heart::NormalRange::Quantity::volumeMl;
    });
  return ranges;
}

std::optional<heart::WallMotion> VolumeMonitor::wall() const {
  const Side& side = sides_[0];
  return side.curves && side.playback->sequence() ? side.curves->wall : std::nullopt;
}

bool VolumeMonitor::isEstimate(std::size_t line) const {
  return measured_ && measured_->isEstimate() && measured_->surfaceOf(lines_[line].organ) &&
         playbackOf(line).sequence() == sides_[0].playback->sequence();
}

bool VolumeMonitor::isUncertain(std::size_t line) const {
  return isEstimate(line) && anatomy::chamberKey(lines_[line].label) == "rv";
}

std::optional<heart::CardiacIndices> VolumeMonitor::indices(std::size_t line) const {
  const Curve curve = cycle(line);
  if (!lines_[line].cavity || curve.milliliters.empty() || isUncertain(line))
    return std::nullopt;
  return heart::cardiacIndices(curve.milliliters, playbackOf(line).player().ratePerMinute());
}

std::optional<std::size_t> VolumeMonitor::measuredLine() const {
  std::optional<std::size_t> first;
  for (std::size_t line = 0; line < lines_.size(); ++line) {
    const bool measured = lines_[line].side == 0 && lines_[line].cavity && measured_ &&
                          measured_->surfaceOf(lines_[line].organ) && !cycle(line).milliliters.empty();
    if (measured && line == chosenLine())
      return line;
    if (measured && !first)
      first = line;
  }
  return first;
}

std::optional<heart::CycleEnds> VolumeMonitor::ends(std::size_t line, const heart::ChosenEnds& chosen) const {
  const Curve curve = cycle(line);
  return curve.milliliters.empty()
             ? std::nullopt
             : std::optional(heart::cycleEnds(curve.fractions, curve.milliliters, chosen));
}

std::vector<heart::HeartNumber> VolumeMonitor::numbers(std::size_t line, const heart::ChosenEnds& chosen,
                                                       double bodySurfaceM2) const {
  const Curve curve = cycle(line);
  if (!lines_[line].cavity || curve.milliliters.empty() || isUncertain(line))
    return {};
  std::vector<std::pair<std::string, double>> organs;
  for (const Line& organ : lines_)
    organs.emplace_back(organ.label, organ.restMl);
  const bool left = anatomy::chamberNamed(lines_[line].label) == anatomy::kLeftVentricle;
  return heart::heartNumbers(
      heart::cardiacIndicesAt(heart::cycleEnds(curve.fractions, curve.milliliters, chosen), curve.fractions,
                              curve.milliliters, playbackOf(line).player().ratePerMinute()),
      left ? heart::muscleGrams(organs) : std::nullopt, bodySurfaceM2);
}

} // namespace viscera::app
