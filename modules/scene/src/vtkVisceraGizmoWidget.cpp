#include "viscera/scene/vtkVisceraGizmoWidget.h"

#include <cstring>
#include <utility>

#include <vtkCallbackCommand.h>
#include <vtkEvent.h>
#include <vtkInteractorStyle.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkWidgetCallbackMapper.h>
#include <vtkWidgetEvent.h>

#include "viscera/scene/gizmo_event.h"
#include "viscera/scene/vtkVisceraGizmoRepresentation.h"

vtkStandardNewMacro(vtkVisceraGizmoWidget);

namespace {

/// Above the handles' widget, which has VTK's standard one.
constexpr float kPriority = 0.6F;

class Listener final : public vtkCommand {
public:
  static Listener* New() { return new Listener; }
  void Execute(vtkObject*, unsigned long, void* data) override {
    call(*static_cast<const viscera::scene::GizmoEvent*>(data));
  }
  std::function<void(const viscera::scene::GizmoEvent&)> call;
};

} // namespace

unsigned long viscera::scene::observe(vtkVisceraGizmoWidget* widget, unsigned long event,
                                      std::function<void(const GizmoEvent&)> listener) {
  vtkNew<Listener> command;
  command->call = std::move(listener);
  return widget->AddObserver(event, command);
}

vtkVisceraGizmoWidget::vtkVisceraGizmoWidget() {
  ManagesCursor = 0;
  KeyPressActivation = 0;
  Priority = kPriority;
  CallbackMapper->SetCallbackMethod(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::Select, this,
                                    PressAction);
  CallbackMapper->SetCallbackMethod(vtkCommand::LeftButtonReleaseEvent, vtkWidgetEvent::EndSelect, this,
                                    ReleaseAction);
  CallbackMapper->SetCallbackMethod(vtkCommand::MouseMoveEvent, vtkWidgetEvent::Move, this, MoveAction);
  CallbackMapper->SetCallbackMethod(vtkCommand::KeyPressEvent, vtkEvent::AnyModifier, 0, 0, "Escape",
                                    vtkWidgetEvent::Reset, this, EscapeAction);
}

vtkVisceraGizmoWidget::~vtkVisceraGizmoWidget() = default;

void vtkVisceraGizmoWidget::SetRepresentation(vtkVisceraGizmoRepresentation* representation) {
  CancelDrag();
  SetWidgetRepresentation(representation);
}

vtkVisceraGizmoRepresentation* vtkVisceraGizmoWidget::GetGizmo() {
  return static_cast<vtkVisceraGizmoRepresentation*>(GetRepresentation());
}

void vtkVisceraGizmoWidget::CreateDefaultRepresentation() {
  if (!WidgetRep)
    WidgetRep = vtkVisceraGizmoRepresentation::New();
}

void vtkVisceraGizmoWidget::SetEnabled(int enabled) {
  if (!enabled)
    CancelDrag();
  // Enabling makes a representation visible; whether this one is, is the program's matter.
  const int visible = WidgetRep ? WidgetRep->GetVisibility() : 0;
  Superclass::SetEnabled(enabled);
  if (WidgetRep)
    WidgetRep->SetVisibility(visible);
}

bool vtkVisceraGizmoWidget::Shown() {
  return WidgetRep && WidgetRep->GetVisibility() && CurrentRenderer;
}

void vtkVisceraGizmoWidget::Tell(unsigned long event) {
  viscera::scene::GizmoEvent payload = GetGizmo()->GetMotion();
  InvokeEvent(event, &payload);
}

void vtkVisceraGizmoWidget::Hover(int x, int y) {
  auto* gizmo = GetGizmo();
  const int part = Shown() && CurrentRenderer->IsInViewport(x, y) ? gizmo->Pick(x, y)
                                                                  : vtkVisceraGizmoRepresentation::Nothing;
  if (part == gizmo->GetActivePart())
    return;
  gizmo->SetActivePart(part);
  Tell(HoveredEvent);
}

void vtkVisceraGizmoWidget::PressAction(vtkAbstractWidget* widget) {
  auto* self = static_cast<vtkVisceraGizmoWidget*>(widget);
  if (!self->Shown() || self->Dragging)
    return;
  const int* at = self->Interactor->GetEventPosition();
  self->Hover(at[0], at[1]);
  if (self->GetGizmo()->GetActivePart() == vtkVisceraGizmoRepresentation::Nothing)
    return;
  self->EventCallbackCommand->SetAbortFlag(1);
  double position[2] = {double(at[0]), double(at[1])};
  self->GetGizmo()->StartWidgetInteraction(position);
  self->Dragging = true;
  self->GrabFocus(self->EventCallbackCommand, self->EventCallbackCommand);
  self->Superclass::StartInteraction();
  self->Tell(GrabbedEvent);
  self->InvokeEvent(vtkCommand::StartInteractionEvent);
}

void vtkVisceraGizmoWidget::MoveAction(vtkAbstractWidget* widget) {
  auto* self = static_cast<vtkVisceraGizmoWidget*>(widget);
  const int* at = self->Interactor->GetEventPosition();
  if (self->Dragging) {
    self->EventCallbackCommand->SetAbortFlag(1);
    double position[2] = {double(at[0]), double(at[1])};
    self->GetGizmo()->WidgetInteraction(position);
    self->Tell(MovedEvent);
    self->InvokeEvent(vtkCommand::InteractionEvent);
    return;
  }
  auto* style = vtkInteractorStyle::SafeDownCast(self->Interactor->GetInteractorStyle());
  if (!style || style->GetState() == VTKIS_NONE)
    self->Hover(at[0], at[1]);
}

void vtkVisceraGizmoWidget::ReleaseAction(vtkAbstractWidget* widget) {
  auto* self = static_cast<vtkVisceraGizmoWidget*>(widget);
  if (!self->Dragging)
    return;
  self->EventCallbackCommand->SetAbortFlag(1);
  self->EndDrag(ReleasedEvent);
}

void vtkVisceraGizmoWidget::EscapeAction(vtkAbstractWidget* widget) {
  auto* self = static_cast<vtkVisceraGizmoWidget*>(widget);
  // An event without a key symbol matches every symbol.
  const char* key = self->Interactor->GetKeySym();
  if (!self->Dragging || !key || std::strcmp(key, "Escape") != 0)
    return;
  self->EventCallbackCommand->SetAbortFlag(1);
  self->CancelDrag();
}

void vtkVisceraGizmoWidget::CancelDrag() {
  if (Dragging)
    EndDrag(CancelledEvent);
}

void vtkVisceraGizmoWidget::EndDrag(unsigned long event) {
  Dragging = false;
  ReleaseFocus();
  Tell(event);
  Superclass::EndInteraction();
  InvokeEvent(vtkCommand::EndInteractionEvent);
}
