#include "window/stress/cut_controller.h"

#include <algorithm>

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include "window/view/cut_sight.h"

namespace viscera::app {

CutController::CutController(Workspace& workspace, StressModel& model, ViewWidget& view, Picture& picture,
                             const HandleController& handles, QObject* parent)
    : QObject(parent), workspace_(workspace), model_(model), view_(view), picture_(picture),
      handles_(handles) {
  widget_->SetRepresentation(picture.presenter().cutPlane());
  widget_->SetInteractor(view.interactor());
  widget_->SetDefaultRenderer(view.view().renderer());
  widget_->SetCurrentRenderer(view.view().renderer());
  listen();
  connect(&picture, &Picture::changed, this, &CutController::enable);
}

CutController::~CutController() {
  for (const unsigned long tag : observers_)
    widget_->RemoveObserver(tag);
  widget_->SetEnabled(0);
  widget_->SetInteractor(nullptr);
}

void CutController::listen() {
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback([](vtkObject*, unsigned long event, void* self, void*) {
    auto& controller = *static_cast<CutController*>(self);
    if (event == vtkCommand::InteractionEvent)
      return controller.onPlaneMoved();
    if (event != vtkCommand::WidgetModifiedEvent)
      controller.view_.view().setMoving(event == vtkCommand::StartInteractionEvent);
    controller.view_.scheduleRender();
  });
  for (const unsigned long event : {vtkCommand::InteractionEvent, vtkCommand::StartInteractionEvent,
                                    vtkCommand::EndInteractionEvent, vtkCommand::WidgetModifiedEvent})
    observers_.push_back(widget_->AddObserver(event, command));
}

/// The plane can be dragged while it is drawn.
void CutController::enable() {
  const scene::TissueActor* tissue = picture_.presenter().tissue();
  const bool wanted = model_.active() && model_.look().cut && tissue && tissue->visible();
  if (static_cast<bool>(widget_->GetEnabled()) != wanted)
    widget_->SetEnabled(wanted);
}

void CutController::onPlaneMoved() {
  const presentation::Presenter& presenter = picture_.presenter();
  const vtkVisceraCutPlaneRepresentation& plane = *presenter.cutPlane();
  model_.change([&](StressLook& look) {
    look.normal = plane.GetPlane().normal;
    look.offset =
        std::clamp((plane.GetMiddle() - presenter.stressMiddle()).dot(look.normal) / presenter.stressRadius(),
                   -1.0, 1.0);
  });
}

void CutController::faceReader() {
  double forward[3];
  view_.view().renderer()->GetActiveCamera()->GetDirectionOfProjection(forward);
  presentation::StressLook look = model_.look();
  look.normal = Vec3(forward).normalized();
  look.offset = 0;
  look.cut = true;
  model_.setLook(look);
}

void CutController::cutAcross(const Vec3& normal) {
  model_.change([&normal](StressLook& look) {
    look.normal = normal;
    look.offset = 0;
  });
  seeCut(view_.view(), normal);
  view_.scheduleRender();
}

void CutController::probeAt(const QPointF& place) {
  if (handles_.underMouse() || widget_->IsUnderCursor())
    return;
  scene::OrganView& view = view_.view();
  scene::TissueActor* tissue = picture_.presenter().tissue();
  const double ratio = view_.devicePixelRatioF();
  const double x = ratio * place.x(), y = ratio * (view_.height() - 1 - place.y());
  const auto surface = view.pick(x, y);
  auto inside = tissue ? tissue->pick(scene::rayThrough(view.renderer(), x, y)) : std::nullopt;
  const bool glyphs = model_.look().glyphs != presentation::GlyphChoice::none;
  // Organs around the map are glass: a click through them means the tissue.
  const bool own = surface && picture_.organOf(surface->organ) == model_.live().organ();
  if (inside && own && surface->distance < inside->distance && !glyphs)
    inside.reset();
  if (inside)
    return model_.setProbe(inside->point);
  const document::OrganId organ = surface ? picture_.organOf(surface->organ) : document::OrganId{};
  if (!organ)
    return model_.setProbe(-1);
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
