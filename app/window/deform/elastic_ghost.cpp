#include "window/deform/elastic_ghost.h"

#include <QPointer>

#include <algorithm>
#include <cmath>
#include <utility>

#include "viscera/core/background.h"
#include "viscera/document/rig.h"
#include "viscera/elasticity/stated_material.h"
#include "window/style/language.h"
#include "window/view/picture.h"
#include "window/view/view_model.h"

namespace viscera::app {
namespace {

constexpr int kStillMilliseconds = 400;
constexpr const char* kElasticSlot = "elasticity";
constexpr double kElasticOpacity = 0.35;
const Vec3 kElasticColor(0.97, 0.83, 0.42);
/// The least end of the legend, mm.
constexpr double kLeastLegendMm = 0.5;

} // namespace

ElasticGhost::ElasticGhost(const ModeParts& parts, QObject* parent)
    : QObject(parent), workspace_(parts.workspace), playback_(parts.playback), view_(parts.view),
      picture_(parts.picture) {
  still_.setSingleShot(true);
  still_.setInterval(kStillMilliseconds);
  connect(&still_, &QTimer::timeout, this, &ElasticGhost::solve);
  connect(&view_, &ViewModel::changed, this, &ElasticGhost::follow);
  connect(&playback_, &Playback::stateChanged, this, &ElasticGhost::follow);
  subscriptions_.push_back(workspace_.onChange([this](const document::Change&) { follow(); }));
  subscriptions_.push_back(workspace_.selection().onChange([this] { follow(); }));
  subscriptions_.push_back(workspace_.live().onEvent([this](const live::LiveEvent& event) {
    if (event.status) { // It may be bound now, or in another way.
      drop();
      follow();
    }
  }));
}

ElasticGhost::~ElasticGhost() {
  workspace_.jobs().cancelSlot(kElasticSlot);
}

/// Deform is the mode with tools; other modes and a sequence show other poses than the document's.
bool ElasticGhost::wanted() const {
  const presentation::ViewState& view = view_.state();
  return view.besideElasticity && view.shown.tools && !playback_.showing();
}

std::optional<ElasticGhost::Cause> ElasticGhost::present() const {
  const auto organ = workspace_.currentOrgan();
  if (!organ)
    return std::nullopt;
  const document::DocumentState& state = workspace_.state();
  return Cause{organ->id, organ->mesh, state.rig, state.system, state.pose};
}

void ElasticGhost::follow() {
  if (!wanted()) {
    drop();
    filled_ = {};
    return tell({});
  }
  const std::optional<Cause> now = present();
  if (!now) {
    drop();
    return tell(tr("There is no organ to compare."));
  }
  if (cause_ == now)
    return;
  drop();
  if (document::atRest(workspace_.state()))
    return tell(tr("Move a handle: at rest there is nothing to compare."));
  tell(tr("The elastic organ is being computed."));
  still_.start();
}

/// Ends what is under way and takes away what is drawn.
void ElasticGhost::drop() {
  still_.stop();
  cause_.reset();
  workspace_.jobs().cancelSlot(kElasticSlot);
  if (std::exchange(drawn_, false)) {
    picture_.setMap(std::nullopt);
    picture_.setMeasured({});
  }
  if (std::exchange(apart_, std::nullopt))
    Q_EMIT changed();
}

void ElasticGhost::tell(const QString& reason) {
  if (std::exchange(reason_, reason) != reason)
    Q_EMIT changed();
}

void ElasticGhost::solve() {
  const std::optional<Cause> now = present();
  if (!now || !wanted() || workspace_.live().busy()) // The organs tell when they are bound.
    return;
  cause_ = now;
  if (workspace_.live().status(now->organ).state != live::BindingStatus::State::bound)
    return tell(tr("Only an organ that follows the handles can be compared."));
  auto filled = filled_.mesh == now->mesh ? filled_ : Filled{now->mesh, nullptr};
  workspace_.jobs().submit<Solved>(
      tr("Elastic organ").toStdString(), kElasticSlot,
      [filled = std::move(filled), posed = workspace_.live().sharedPoints(now->organ),
       rest = now->rig->restPositions(), pose = now->pose](Progress& progress) {
        Solved solved{filled, {}};
        inBackground([&] {
          if (!solved.filled.organ) // The modulus is arbitrary: it changes no displacement.
            solved.filled.organ = std::make_shared<const elasticity::ElasticOrgan>(
                *filled.mesh, elasticity::OrganOptions(),
                std::make_shared<const elasticity::NeoHookean>(1, elasticity::kUsualPoisson), progress);
          solved.comparison = live::besideElasticity(
              *solved.filled.organ,
              {.surface = filled.mesh->points, .posed = *posed, .rest = rest, .pose = *pose}, progress);
        });
        return solved;
      },
      [ghost = QPointer<ElasticGhost>(this), cause = *now](JobResult<Solved> result) {
        if (ghost)
          ghost->take(cause, std::move(result));
      });
}

/// What fails, or was cancelled in the list of jobs, is not tried again before the pose is another one.
void ElasticGhost::take(const Cause& cause, JobResult<Solved> result) {
  if (cause_ != cause) // It was cancelled for another pose.
    return;
  if (result.cancelled())
    return tell(tr("The comparison was cancelled. Move a handle, or switch it off and on again."));
  if (result.error)
    return tell(sentenceOf(*result.error));
  filled_ = result.value->filled;
  draw(cause, result.value->comparison);
}

void ElasticGhost::draw(const Cause& cause, const live::ElasticComparison& comparison) {
  presentation::SurfaceMap map;
  map.colors = scene::viridis();
  map.title = tr("Distance from elasticity").toStdString();
  map.unit = "mm";
  map.range = {0, std::max(kLeastLegendMm, std::ceil(2 * comparison.apart.maxMm) / 2)};
  map.values[cause.organ] = std::make_shared<const Values>(comparison.distancesMm);
  auto elastic = std::make_shared<geometry::TriangleMesh>();
  elastic->points = comparison.elastic;
  elastic->triangles = cause.mesh->triangles;
  picture_.setMap(std::move(map));
  picture_.setMeasured({{std::move(elastic), kElasticColor, kElasticOpacity}});
  drawn_ = true;
  apart_ = comparison.apart;
  reason_.clear();
  Q_EMIT changed();
}

} // namespace viscera::app
