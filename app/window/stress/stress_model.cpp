#include "window/stress/stress_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "viscera/document/stress_mark_commands.h"
#include "window/style/language.h"

namespace viscera::app {
namespace {

constexpr int kStressUpdateMilliseconds = 100;
constexpr const char* kSetting = "stress/look";

/// The witness with the largest value of a quantity (the smallest, of the smallest stretch) among those with
/// a value, as for the numbers of the page: folded tissue has no value except on the map of folded tissue.
/// -1: all are folded.
int extremeOf(const deformation::StressMap& map, const live::StressMeasure& measure, Eigen::Index witnesses) {
  const double sign = measure.quantity == live::StressQuantity::stretchMin ? -1 : 1;
  int most = -1;
  double value = 0;
  for (int point = 0; point < static_cast<int>(witnesses); ++point) {
    if (map.volumeRatio[point] <= 0 && measure.quantity != live::StressQuantity::folded)
      continue;
    const double here = sign * live::quantityAt(map, measure, point);
    if (!std::isfinite(here))
      continue;
    if (most < 0 || here > value) {
      most = point;
      value = here;
    }
  }
  return most;
}

/// The unit vector perpendicular to `direction` that is nearest to `wish`; both are unit vectors.
Vec3 perpendicularTo(const Vec3& direction, const Vec3& wish) {
  constexpr double kParallel = 1e-6;
  const Vec3 across = wish - wish.dot(direction) * direction;
  return across.norm() > kParallel ? across.normalized() : direction.unitOrthogonal();
}

} // namespace

StressModel::StressModel(Workspace& workspace, Playback& playback, Settings& settings, ViewModel& view,
                         const Picture& picture, QObject* parent)
    : QObject(parent), workspace_(workspace), playback_(playback), settings_(settings), view_(view),
      picture_(picture), live_(workspace.stress()), cycle_(workspace, playback) {
  throttle_.setSingleShot(true);
  throttle_.setInterval(kStressUpdateMilliseconds);
  connect(&throttle_, &QTimer::timeout, this, &StressModel::updated);
  connect(&playback, &Playback::advanced, this, [this] {
    if (!active())
      return;
    Q_EMIT instantChanged();
    if (!throttle_.isActive())
      throttle_.start();
  });
  connect(&playback, &Playback::stateChanged, this, &StressModel::updated);
  connect(&view, &ViewModel::changed, this, &StressModel::onView);
  connect(&picture, &Picture::changed, this, &StressModel::shownChanged);
  connect(&picture, &Picture::changed, this, [this] {
    if (active())
      Q_EMIT numbersChanged();
  });
  subscriptions_.push_back(live_.onEvent([this](const live::StressEvent& event) { onStress(event); }));
  subscriptions_.push_back(workspace.selection().onChange([this] { follow(); }));
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.organs())
      follow();
    if (change.stressMarks() || change.organs()) {
      Q_EMIT marksChanged();
      if (!throttle_.isActive()) // The picture may not have read them yet.
        throttle_.start();
    }
  }));
  const std::string kept = settings.value(kSetting).toString().toStdString();
  view.change([&](presentation::ViewState& state) { state.stress = presentation::stressLookFromJson(kept); });
  onView();
}

void StressModel::follow() {
  const auto current = workspace_.currentOrgan();
  const document::OrganId organ = current ? current->id : document::OrganId{};
  if (std::exchange(organ_, organ) != organ && !mesh_)
    setProbe(-1); // The probe waits for the mesh of another organ.
  workspace_.guarded([&] { live_.follow(active() ? organ : document::OrganId{}); });
}

/// Called when the view's state has changed; emits signals for the parts that concern the stress.
void StressModel::onView() {
  cycle_.setWanted(!active()     ? std::nullopt
                   : look().peak ? std::optional(live::CycleParts::curveAndPeak)
                                 : live::CycleParts::curve,
                   look().material.poisson);
  if (const bool now = active(); std::exchange(knownActive_, now) != now) {
    follow();
    Q_EMIT activeChanged();
    Q_EMIT updated();
  }
  const StressLook before = std::exchange(known_, look());
  if (known_ == before)
    return;
  workspace_.guarded([&] { live_.setWanted(known_.witnesses); });
  settings_.setValue(kSetting, QString::fromStdString(presentation::toJson(presentation::habitOf(known_))));
  if (known_.probe != before.probe)
    Q_EMIT probeChanged();
  if (known_.peak != before.peak)
    Q_EMIT statusChanged();
  Q_EMIT lookChanged();
  Q_EMIT updated();
}

void StressModel::setLook(StressLook wanted) {
  const bool otherPascals = live::describe(wanted.quantity).ofMaterial && wanted.material != look().material;
  if (wanted.quantity != look().quantity || otherPascals) {
    wanted.pinned = wanted.threshold = false; // They were meant for the other numbers.
    wanted.range = {0, 0};
  } else if (wanted.pinned && !look().pinned) {
    wanted.range = shown().range();
  }
  view_.change([&](presentation::ViewState& state) { state.stress = wanted; });
}

void StressModel::change(const std::function<void(StressLook&)>& edit) {
  StressLook changed = look();
  edit(changed);
  setLook(std::move(changed));
}

void StressModel::onStress(const live::StressEvent& event) {
  if (event.sampled) {
    const auto before = std::exchange(mesh_, live_.mesh());
    // A probe ends with its mesh; that of an opened session waits until its mesh is sampled again.
    if (before || !mesh_ || probe() >= mesh_->points.rows())
      setProbe(-1);
    Q_EMIT sampled();
  }
  if (event.status || event.cycle)
    Q_EMIT statusChanged();
  if ((event.moved || event.cycle || event.sampled) && !throttle_.isActive())
    throttle_.start();
}

QString StressModel::title() const {
  const live::StressQuantityDescription& quantity = live::describe(look().quantity);
  return inWords(peakShown() ? quantity.peakName : quantity.name);
}

QString StressModel::format(double value) const {
  const live::StressQuantityDescription& quantity = live::describe(look().quantity);
  const QString number = formatNumber(value, quantity.decimals);
  return quantity.unit.empty() ? number : tr("%1 %2").arg(number, inWords(look().measure().shortUnit()));
}

std::optional<double> StressModel::shownFraction() const {
  return playback_.showing() ? std::optional(playback_.player().fraction()) : std::nullopt;
}

void StressModel::setPeakShown(bool shown) {
  if (shown)
    cycle_.retry(); // After a search that was cancelled.
  view_.change([&](presentation::ViewState& state) {
    if (state.stress.peak != shown && !state.stress.pinned)
      state.stress.range = {0, 0};
    state.stress.peak = shown;
  });
}

const live::StressSample* StressModel::peakInstant() const {
  return cycle() ? cycle()->worst() : nullptr;
}

void StressModel::goToPeak() {
  const live::StressSample* instant = peakInstant();
  if (!instant || !playback_.sequence())
    return;
  const double fraction = instant->seconds / cycle()->periodSeconds;
  setPeakShown(false);
  playback_.seek(fraction);
}

bool StressModel::hasMap() const {
  const auto mesh = live_.mesh();
  return active() && mesh && workspace_.document().organ(live_.organ()) &&
         shownMap().volumeRatio.size() >= mesh->witnesses && live_.points().rows() >= mesh->witnesses;
}

void StressModel::goToMaximum() {
  if (!hasMap())
    return;
  const int most = extremeOf(shownMap(), look().measure(), live_.mesh()->witnesses);
  if (most < 0)
    return;
  const presentation::Presenter& drawn = picture_.presenter();
  // The tissue is drawn, and cut, in its pose.
  const Vec3 from = Vec3(live_.points().row(most).transpose()) - drawn.stressMiddle();
  change([&](StressLook& look) {
    look.probe = most;
    if (!(drawn.stressRadius() > 0))
      return;
    look.cut = true; // The largest value may lie deep inside.
    look.offset = from.dot(look.normal) / drawn.stressRadius();
    if (std::abs(look.offset) <= 1)
      return;
    // The point lies beyond the range of the plane, so the plane is rotated to go through the middle and the
    // point.
    look.normal = perpendicularTo(from.normalized(), look.normal);
    look.offset = 0;
  });
}

bool StressModel::hasProbes() const {
  const auto& probes = workspace_.document().stressMarks().probes;
  return std::any_of(probes.begin(), probes.end(),
                     [this](const document::StressProbe& probe) { return probe.organ == live_.organ(); });
}

bool StressModel::hasProfiles() const {
  const document::StressMarks& marks = workspace_.document().stressMarks();
  return std::any_of(marks.lines.begin(), marks.lines.end(), [&](const document::StressLine& line) {
    const document::StressProbe* from = marks.probe(line.from);
    return from && marks.probe(line.to) && from->organ == live_.organ();
  });
}

void StressModel::pinProbe() {
  const auto mesh = live_.mesh();
  if (!active() || !mesh || probe() < 0 || probe() >= mesh->points.rows())
    return;
  const Vec3 rest = mesh->points.row(probe()).transpose();
  for (const document::StressProbe& pinned : workspace_.document().stressMarks().probes)
    if (pinned.organ == live_.organ() && pinned.rest == rest)
      return workspace_.note(tr("This point is probe %1 already.").arg(pinned.number));
  workspace_.perform(document::addStressProbe(live_.organ(), rest));
}

} // namespace viscera::app
