#include "window/stress/stress_scene.h"

#include <QPointer>
#include <QScopedValueRollback>

#include <algorithm>
#include <cmath>
#include <limits>

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"

namespace viscera::app {
namespace {

constexpr int kGlyphs = 300;
/// The radius of a glyph, of the distance between them.
constexpr double kGlyphSize = 0.33;
/// Handles this little on the side that is cut away stay, of the organ's radius.
constexpr double kHandleSlack = 0.08;

std::shared_ptr<const Points> lookAt(const Points& points) {
  return {std::shared_ptr<void>(), &points};
}

} // namespace

StressScene::StressScene(Workspace& workspace, StressModel& model, ViewWidget& view, OrganScene& organs,
                         HandleScene& handles, QObject* parent)
    : QObject(parent), workspace_(workspace), model_(model), view_(view), organs_(organs), handles_(handles),
      glyphs_(std::make_unique<scene::StretchGlyphs>()) {
  vtkRenderer* renderer = view.view().renderer();
  glyphs_->setRenderer(renderer);
  marker_.setRenderer(renderer);
  plane_->SetRenderer(renderer);
  planeWidget_->SetRepresentation(plane_);
  planeWidget_->SetInteractor(view.interactor());
  planeWidget_->SetDefaultRenderer(renderer);
  planeWidget_->SetCurrentRenderer(renderer);
  const auto listen = [&](unsigned long event, void (*call)(vtkObject*, unsigned long, void*, void*)) {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback(call);
    observers_.push_back(planeWidget_->AddObserver(event, command));
  };
  listen(vtkCommand::InteractionEvent, [](vtkObject*, unsigned long, void* self, void*) {
    static_cast<StressScene*>(self)->onPlaneMoved();
  });
  const auto changesLook = [](vtkObject*, unsigned long event, void* self, void*) {
    auto& scene = *static_cast<StressScene*>(self);
    if (event != vtkCommand::WidgetModifiedEvent)
      scene.view_.view().setMoving(event == vtkCommand::StartInteractionEvent);
    Q_EMIT scene.changed();
  };
  for (const unsigned long event :
       {vtkCommand::StartInteractionEvent, vtkCommand::EndInteractionEvent, vtkCommand::WidgetModifiedEvent})
    listen(event, changesLook);
  view.view().setAlsoFramed([this]() -> std::optional<Bounds> {
    if (!model_.active() || !tissue_ || !tissue_->visible())
      return std::nullopt;
    return boundsOf(tissue_->points());
  });
  connect(&model, &StressModel::activeChanged, this, &StressScene::onActive);
  connect(&model, &StressModel::sampled, this, &StressScene::onSampled);
  connect(&model, &StressModel::shownChanged, this, &StressScene::sync);
  connect(&model, &StressModel::lookChanged, this, &StressScene::syncCut);
  connect(&model, &StressModel::probeChanged, this, &StressScene::syncProbe);
  connect(&organs, &OrganScene::looksApplied, this, &StressScene::sync);
  connect(&view, &ViewWidget::clicked, this, [this](const QPointF& place) { onClick(place); });
}

StressScene::~StressScene() {
  view_.view().setAlsoFramed(nullptr);
  handles_.setShownWhere(nullptr);
  if (tissue_)
    for (vtkActor* actor : {tissue_->faces(), tissue_->cut()})
      view_.view().handles()->RemoveOccluder(actor);
  for (const unsigned long tag : observers_)
    planeWidget_->RemoveObserver(tag);
  planeWidget_->SetEnabled(0);
  planeWidget_->SetInteractor(nullptr);
}

void StressScene::setTheme(const scene::Theme& theme) {
  plane_->SetTheme(theme);
  marker_.setTheme(theme);
}

scene::CutPlane StressScene::cutPlane() const {
  return plane_->GetPlane();
}

scene::OrganActor* StressScene::organActor() const {
  for (const auto& actor : view_.view().organs())
    if (organs_.organOf(actor.get()) == model_.live().organ())
      return actor.get();
  return nullptr;
}

/// Whether the organ's own surface carries the map; else the tetrahedra do.
bool StressScene::organShown() const {
  const StressLook& look = model_.look();
  return look.onSurface && !look.threshold && look.glyphs == GlyphChoice::none && onSurface_ &&
         !(look.cut && look.style == scene::CutStyle::crinkle);
}

void StressScene::onActive() {
  organs_.setSuspended(model_.active());
  legendTitle_.clear();
  if (model_.active() && model_.live().mesh() && !tissue_)
    onSampled();
  syncCut();
  sync();
}

void StressScene::onSampled() {
  auto* occluded = view_.view().handles();
  if (tissue_)
    for (vtkActor* actor : {tissue_->faces(), tissue_->cut()})
      occluded->RemoveOccluder(actor);
  tissue_.reset();
  onSurface_.reset();
  glyphPoints_.clear();
  const auto mesh = model_.live().mesh();
  if (!mesh || !model_.active())
    return sync();
  const Bounds box = boundsOf(mesh->points);
  middle_ = box.center();
  radius_ = 0.5 * (box.high - box.low).maxCoeff();
  plane_->SetBall(middle_, radius_);
  tissue_ =
      std::make_unique<scene::TissueActor>(std::shared_ptr<const scene::Tetrahedra>(mesh, &mesh->tetrahedra),
                                           std::shared_ptr<const Points>(mesh, &mesh->points));
  tissue_->setVisible(false);
  tissue_->setRenderer(view_.view().renderer());
  for (vtkActor* actor : {tissue_->faces(), tissue_->cut()})
    occluded->AddOccluder(actor);
  // What is seen through the tissue has to be drawn after it.
  marker_.setRenderer(view_.view().renderer());
  planeWidget_->SetEnabled(0);
  interpolateLater();
  syncCut();
  sync();
}

/// Where the organ's vertices lie among the witnesses: takes a while for a large surface.
void StressScene::interpolateLater() {
  const auto organ = workspace_.document().organ(model_.live().organ());
  if (!organ)
    return;
  using Interpolation = std::shared_ptr<const deformation::WitnessInterpolation>;
  const auto mesh = model_.live().mesh();
  const auto work = [mesh, surface = organ->mesh](Progress&) -> Interpolation {
    return std::make_shared<const deformation::WitnessInterpolation>(*mesh, surface->points);
  };
  const auto done = [self = QPointer<StressScene>(this), mesh](JobResult<Interpolation> result) {
    if (!self || !result.value || self->model_.live().mesh() != mesh)
      return;
    self->onSurface_ = *result.value;
    self->sync();
  };
  workspace_.jobs().submit<Interpolation>(tr("Map on the surface").toStdString(), "stress/surface", work,
                                          done);
}

void StressScene::sync() {
  if (model_.active()) {
    syncTissue();
    syncValues();
  }
  syncOrgans();
  syncGlyphs();
  syncLegend();
  syncProbe();
  Q_EMIT changed();
}

void StressScene::syncTissue() {
  if (!tissue_)
    return;
  const StressLook& look = model_.look();
  const auto mesh = model_.live().mesh();
  const bool any = mesh && model_.live().points().rows() == mesh->points.rows() &&
                   model_.values()->size() == mesh->points.rows();
  tissue_->setVisible(any && (!organShown() || look.cut));
  if (!any) { // The points that were drawn may be gone.
    if (mesh)
      tissue_->setPoints(std::shared_ptr<const Points>(mesh, &mesh->points));
    return;
  }
  tissue_->setPoints(lookAt(model_.live().points()));
  tissue_->setValues(model_.values());
  tissue_->setGhost(look.glyphs != GlyphChoice::none);
  tissue_->setOutsideShown(!organShown());
  if (look.threshold) {
    constexpr double kEverything = std::numeric_limits<double>::infinity();
    tissue_->setShownRange(look.below ? scene::ValueRange{-kEverything, look.limit}
                                      : scene::ValueRange{look.limit, kEverything});
  } else {
    tissue_->clearShownRange();
  }
}

void StressScene::syncValues() {
  if (!model_.ready())
    return;
  if (tissue_)
    tissue_->setColors(model_.colors(), model_.range());
  glyphs_->setColors(model_.colors(), model_.range());
  if (organShown())
    (*onSurface_)(*model_.values(), *surfaceValues_);
}

void StressScene::syncOrgans() {
  if (!model_.active())
    return;
  const StressLook& look = model_.look();
  const bool map = model_.ready() && tissue_;
  const scene::OrganActor* followed = organActor();
  for (const auto& actor : view_.view().organs()) {
    const auto organ = workspace_.document().organ(organs_.organOf(actor.get()));
    if (!organ)
      continue;
    if (actor.get() != followed) {
      // The organ's cavities are left out of the tissue: what is seen there are their walls, cut likewise.
      const bool cavity = organ->parent == model_.live().organ();
      const bool walls = cavity && map && look.cut && !look.threshold && look.glyphs == GlyphChoice::none;
      actor->setVisible(organ->look.visible && (cavity ? walls : look.others));
      if (walls)
        actor->setClipPlane(plane_->GetPlane().origin, plane_->GetPlane().normal);
      continue;
    }
    actor->setVisible(!map || organShown());
    actor->setOpacity(map ? 1 : organ->look.opacity);
    if (map && organShown())
      actor->showScalars(surfaceValues_, model_.colors(), model_.range());
    else if (actor->scalarsShown())
      actor->hideScalars();
    if (map && look.cut)
      actor->setClipPlane(plane_->GetPlane().origin, plane_->GetPlane().normal);
    else
      actor->clearClipPlane();
  }
}

/// Brings the plane to where the settings have it, and the widget with it.
void StressScene::syncCut() {
  const StressLook& look = model_.look();
  if (!planeFromWidget_)
    plane_->SetPlane({middle_ + look.offset * radius_ * look.normal, look.normal});
  const bool cut = model_.active() && look.cut && tissue_;
  if (static_cast<bool>(planeWidget_->GetEnabled()) != cut)
    planeWidget_->SetEnabled(cut);
  if (tissue_ && look.cut)
    tissue_->setCut(plane_->GetPlane(), look.style);
  else if (tissue_)
    tissue_->clearCut();
  syncHandles();
}

/// Handles on the side that is cut away go with it: else they would hide the cut.
void StressScene::syncHandles() {
  const StressLook& look = model_.look();
  if (!model_.active() || (look.handles && !(look.cut && tissue_)))
    return handles_.setShownWhere(nullptr);
  if (!look.handles)
    return handles_.setShownWhere([](const Vec3&) { return false; });
  const double slack = kHandleSlack * radius_;
  handles_.setShownWhere([plane = plane_->GetPlane(), slack](const Vec3& place) {
    return (place - plane.origin).dot(plane.normal) >= -slack;
  });
}

void StressScene::onPlaneMoved() {
  const QScopedValueRollback<bool> quiet(planeFromWidget_, true);
  StressLook look = model_.look();
  const scene::CutPlane plane = plane_->GetPlane();
  look.normal = plane.normal;
  look.offset = std::clamp((plane_->GetMiddle() - middle_).dot(plane.normal) / radius_, -1.0, 1.0);
  model_.setLook(look);
}

void StressScene::faceReader() {
  double forward[3];
  view_.view().renderer()->GetActiveCamera()->GetDirectionOfProjection(forward);
  StressLook look = model_.look();
  look.normal = Vec3(forward).normalized();
  look.offset = 0;
  look.cut = true;
  model_.setLook(look);
}

bool StressScene::kept(const Vec3& point) const {
  return !model_.look().cut || (point - plane_->GetPlane().origin).dot(plane_->GetPlane().normal) >= 0;
}

bool StressScene::inRange(double value) const {
  const StressLook& look = model_.look();
  return !look.threshold || !std::isfinite(value) || (look.below ? value <= look.limit : value >= look.limit);
}

void StressScene::syncGlyphs() {
  const GlyphChoice choice = model_.look().glyphs;
  const auto mesh = model_.live().mesh();
  const bool shown = model_.active() && model_.ready() && tissue_ && choice != GlyphChoice::none;
  glyphs_->setVisible(shown);
  if (!shown)
    return;
  if (glyphPoints_.empty()) {
    glyphPoints_ = deformation::thinnedPoints(mesh->points, mesh->witnesses, kGlyphs);
    const double volume = deformation::tetrahedronVolumes(mesh->points, mesh->tetrahedra).cwiseAbs().sum();
    glyphs_->setRadius(kGlyphSize * std::cbrt(volume / static_cast<double>(glyphPoints_.size())));
  }
  glyphs_->setShape(choice == GlyphChoice::ellipsoids ? scene::StretchGlyphs::Shape::ellipsoids
                                                      : scene::StretchGlyphs::Shape::crosses);
  std::vector<scene::StretchGlyph> all;
  for (const int point : glyphPoints_) {
    scene::StretchGlyph glyph;
    glyph.position = model_.live().points().row(point);
    glyph.value = (*model_.values())[point];
    if (!kept(glyph.position) || !inRange(glyph.value))
      continue;
    const auto stretches = model_.live().stretchesAt(point);
    glyph.directions = stretches.directions;
    glyph.stretches = stretches.stretches;
    all.push_back(glyph);
  }
  glyphs_->set(all);
}

void StressScene::syncLegend() {
  if (!model_.active())
    return;
  scene::Legend& legend = view_.view().legend();
  if (!model_.ready() || !tissue_) {
    legend.hide();
    legendTitle_.clear();
    return;
  }
  const std::string title = model_.title().toStdString();
  const bool folded = model_.folded() > 0;
  const scene::ValueRange range = model_.range();
  if (title == legendTitle_ && range.low == legendRange_.low && range.high == legendRange_.high &&
      folded == legendFolded_ && legend.visible())
    return;
  legendTitle_ = title;
  legendRange_ = range;
  legendFolded_ = folded;
  legend.show(title, live::describe(model_.look().quantity).unit, model_.colors(), range);
  const auto& color = model_.colors().missing;
  legend.setMark(folded ? tr("folded").toStdString() : std::string(),
                 Vec3(color[0], color[1], color[2]) / 255);
}

void StressScene::syncProbe() {
  const int point = model_.probe();
  if (model_.active() && tissue_ && point >= 0 && point < model_.live().points().rows())
    marker_.show(model_.live().points().row(point).transpose());
  else
    marker_.hide();
  Q_EMIT changed();
}

/// A click asks for the values at the nearest point of what is seen there.
void StressScene::onClick(const QPointF& place) {
  if (!model_.active() || handles_.handleUnderMouse() || planeWidget_->IsUnderCursor())
    return;
  const double ratio = view_.devicePixelRatioF();
  const double x = ratio * place.x(), y = ratio * (view_.height() - 1 - place.y());
  const auto surface = view_.view().pick(x, y);
  auto inside = tissue_ ? tissue_->pick(scene::rayThrough(view_.view().renderer(), x, y)) : std::nullopt;
  if (inside && surface && surface->distance < inside->distance && model_.look().glyphs == GlyphChoice::none)
    inside.reset();
  if (inside)
    return model_.setProbe(inside->point);
  if (!surface)
    return model_.setProbe(-1);
  const document::OrganId organ = organs_.organOf(surface->organ);
  if (organ != model_.live().organ())
    return workspace_.selection().setOrgan(organ);
  const Points& points = model_.live().points();
  if (points.rows() == 0)
    return;
  Eigen::Index nearest = 0;
  (points.rowwise() - surface->position.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
  model_.setProbe(static_cast<int>(nearest));
}

} // namespace viscera::app
