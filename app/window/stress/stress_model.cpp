#include "window/stress/stress_model.h"

#include <cmath>

#include "viscera/presentation/value_steps.h"

namespace viscera::app {
namespace {

constexpr int kUpdateMilliseconds = 100;
/// Samples kept: two minutes at 60 frames a second.
constexpr std::size_t kSamples = 7200;
/// Magenta is in neither map.
constexpr std::array<std::uint8_t, 3> kFoldedColor = {232, 40, 200};

} // namespace

StressModel::StressModel(Workspace& workspace, Playback& playback, Settings& settings, QObject* parent)
    : QObject(parent), workspace_(workspace), playback_(playback), settings_(settings),
      live_(workspace.stress()), look_(loadStressLook(settings)), record_(kSamples) {
  live_.setWanted(look_.witnesses);
  throttle_.setSingleShot(true);
  throttle_.setInterval(kUpdateMilliseconds);
  connect(&throttle_, &QTimer::timeout, this, &StressModel::updated);
  connect(&playback, &Playback::advanced, this, &StressModel::sample);
  connect(&playback, &Playback::stateChanged, this, [this] {
    if (!playback_.showing())
      record_.clear();
    Q_EMIT updated();
  });
  subscriptions_.push_back(live_.onEvent([this](const live::StressEvent& event) { onStress(event); }));
  subscriptions_.push_back(workspace.selection().onChange([this] { follow(); }));
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.organs())
      follow();
  }));
  recompute();
}

StressModel::~StressModel() = default;

void StressModel::setActive(bool active) {
  if (active == active_)
    return;
  active_ = active;
  record_.clear();
  follow();
  recompute();
  Q_EMIT activeChanged();
  Q_EMIT updated();
}

void StressModel::follow() {
  const auto organ = active_ ? workspace_.currentOrgan() : nullptr;
  live_.follow(organ ? organ->id : document::OrganId{});
}

void StressModel::setLook(const StressLook& look) {
  if (look == look_)
    return;
  const bool otherQuantity = look.quantity != look_.quantity;
  look_ = look;
  saveStressLook(look_, settings_);
  workspace_.guarded([&] { live_.setWanted(look_.witnesses); });
  if (otherQuantity) {
    look_.pinned = look_.threshold = false; // They were meant for the other numbers.
    range_ = {0, 0};
  }
  recompute();
  Q_EMIT lookChanged();
  Q_EMIT shownChanged();
  Q_EMIT updated();
}

void StressModel::onStress(const live::StressEvent& event) {
  if (event.peak)
    peakShown_ = live_.peak() != nullptr;
  if (event.sampled) {
    record_.clear();
    range_ = {0, 0};
    probe_ = -1;
  }
  if (event.moved || event.peak || event.sampled)
    recompute();
  if (event.sampled) {
    Q_EMIT sampled();
    Q_EMIT probeChanged();
  }
  if (event.status || event.peak)
    Q_EMIT statusChanged();
  if (event.moved || event.peak || event.sampled) {
    Q_EMIT shownChanged();
    if (!throttle_.isActive())
      throttle_.start();
  }
}

const deformation::StressMap& StressModel::shownMap() const {
  return peakShown() ? live_.peak()->map : live_.map();
}

/// The numbers of this instant. They keep their place in memory, so that nobody has to look for them anew.
void StressModel::recompute() {
  const live::StressQuantityDescription& quantity = live::describe(look_.quantity);
  const char* wanted = quantity.ratio ? "diverging" : "viridis";
  if (colors_.name != wanted) {
    colors_ = scene::colorMapByName(wanted);
    colors_.missing = kFoldedColor;
  }
  live::quantityOf(shownMap(), look_.quantity, *values_);
  if (!ready()) {
    summary_ = {};
    return;
  }
  summary_ = live::summaryOf(*values_, live_.mesh()->witnesses);
  if (!look_.pinned || range_.high <= range_.low)
    range_ = presentation::steppedRange(look_.quantity, {summary_.percentile5, summary_.percentile95}, range_);
}

int StressModel::folded() const {
  if (!ready())
    return 0;
  return static_cast<int>((shownMap().volumeRatio.head(live_.mesh()->witnesses).array() <= 0).count());
}

QString StressModel::title() const {
  const QString name = text(live::describe(look_.quantity).name);
  return peakShown() ? tr("Peak of %1").arg(name.left(1).toLower() + name.mid(1)) : name;
}

QString StressModel::format(double value) const {
  const live::StressQuantityDescription& quantity = live::describe(look_.quantity);
  const QString number = QString::number(value, 'f', quantity.decimals);
  return quantity.unit.empty() ? number : tr("%1 %2").arg(number, text(quantity.unit));
}

void StressModel::setPeakShown(bool shown) {
  if (shown == peakShown_)
    return;
  peakShown_ = shown;
  range_ = look_.pinned ? range_ : scene::ValueRange{0, 0};
  recompute();
  Q_EMIT statusChanged();
  Q_EMIT shownChanged();
  Q_EMIT updated();
}

void StressModel::findPeak() {
  const sequences::Sequence* sequence = playback_.sequence();
  if (!sequence)
    return;
  if (live_.peak())
    return setPeakShown(true);
  workspace_.guarded([&] { live_.findPeak(playback_.sharedSequence(), playback_.player().ratePerMinute()); });
}

void StressModel::sample() {
  if (!active_ || live_.status().state != live::StressStatus::State::ready)
    return;
  const double seconds = playback_.player().playedSeconds();
  const auto& samples = record_.samples();
  // The same instant again is no news; a record that is given one begins anew.
  if (samples.empty() || samples.back().seconds != seconds)
    record_.add({seconds, live_.statistics()});
  if (!throttle_.isActive())
    throttle_.start();
}

void StressModel::setProbe(int point) {
  probe_ = point;
  Q_EMIT probeChanged();
}

} // namespace viscera::app
