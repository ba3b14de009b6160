#include "window/compare/difference_map.h"

#include <QTimer>

#include <algorithm>
#include <cmath>
#include <utility>

#include "viscera/presentation/stress_values.h"
#include "window/style/language.h"

namespace viscera::app {
namespace {

/// The next of 1, 2, 5 times a power of ten: a legend with round ends that seldom change.
double roundedUp(double value) {
  const double decade = std::pow(10, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0})
    if (value <= step * decade)
      return step * decade;
  return 10 * decade;
}

/// Below it the two agree, mm: the legend needs an end.
constexpr double kLeast = 1e-3;

} // namespace

DifferenceMap::DifferenceMap(Workspace& first, Workspace& second, const ViewModel& view, Picture& picture,
                             QObject* parent)
    : QObject(parent), first_(first), second_(second), view_(view), picture_(picture) {
  for (Workspace* workspace : {&first, &second}) {
    subscriptions_.push_back(workspace->live().onEvent([this](const live::LiveEvent&) { followSoon(); }));
    subscriptions_.push_back(workspace->stress().onEvent([this](const live::StressEvent&) { followSoon(); }));
  }
  connect(&view, &ViewModel::changed, this, &DifferenceMap::followSoon);
}

DifferenceMap::~DifferenceMap() {
  picture_.setMap(std::nullopt);
}

void DifferenceMap::setOn(bool on) {
  on_ = on;
  restart();
  if (!on)
    picture_.setMap(std::nullopt);
}

void DifferenceMap::restart() {
  reach_ = 0;
  followSoon();
}

/// Once for a frame, when both documents have moved.
void DifferenceMap::followSoon() {
  if (!on_ || waiting_)
    return;
  waiting_ = true;
  QTimer::singleShot(0, this, [this] {
    waiting_ = false;
    if (on_)
      follow();
  });
}

void DifferenceMap::follow() {
  const bool stress = view_.state().shown.stress;
  const auto measure = stress ? std::optional(view_.state().stress.measure()) : std::nullopt;
  if (std::exchange(measure_, measure) != measure)
    reach_ = 0;
  picture_.setMap(stress ? stressDifference() : distances());
}

/// None until both views have the stress of the same witness points.
std::optional<presentation::SurfaceMap> DifferenceMap::stressDifference() {
  const live::StressFrame now = first_.stress().frame(), kept = second_.stress().frame();
  const live::StressQuantityDescription& quantity = live::describe(measure_->quantity);
  const auto difference = live::differenceOf(now, kept, *measure_);
  if (!measure_->known() || !difference || now.organ != kept.organ || !kept.onSurface)
    return std::nullopt;
  auto onSurface = std::make_shared<Values>();
  (*kept.onSurface)(*difference, *onSurface);
  greatest_ = 0;
  for (const double value : *onSurface)
    if (std::isfinite(value))
      greatest_ = std::max(greatest_, std::abs(value));
  presentation::SurfaceMap map;
  map.colors = presentation::stressColors("diverging");
  map.title = tr("%1: view 1 less view 2").arg(inWords(quantity.name)).toStdString();
  map.unit = inWords(measure_->unit()).toStdString();
  map.mark = inWords("folded").toStdString();
  map.values[kept.organ] = std::move(onSurface);
  reach_ = std::max(reach_, roundedUp(std::max(greatest_, kLeast)));
  map.range = {-reach_, reach_};
  return map;
}

presentation::SurfaceMap DifferenceMap::distances() {
  presentation::SurfaceMap map;
  map.colors = scene::viridis();
  map.title = tr("Distance to view 1").toStdString();
  map.unit = "mm";
  greatest_ = 0;
  for (const auto& organ : second_.document().organs()) {
    if (!first_.document().organ(organ->id))
      continue;
    const Points& here = second_.live().points(organ->id);
    const Points& there = first_.live().points(organ->id);
    if (here.rows() != there.rows() || here.rows() == 0)
      continue;
    auto distances = std::make_shared<Values>((here - there).rowwise().norm());
    greatest_ = std::max(greatest_, distances->maxCoeff());
    map.values[organ->id] = std::move(distances);
  }
  reach_ = std::max(reach_, roundedUp(std::max(greatest_, kLeast)));
  map.range = {0, reach_};
  return map;
}

} // namespace viscera::app
