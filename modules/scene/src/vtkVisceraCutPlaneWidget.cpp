#include "viscera/scene/vtkVisceraCutPlaneWidget.h"

#include <vtkCallbackCommand.h>
#include <vtkInteractorStyle.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkWidgetCallbackMapper.h>
#include <vtkWidgetEvent.h>

#include "viscera/scene/vtkVisceraCutPlaneRepresentation.h"

vtkStandardNewMacro(vtkVisceraCutPlaneWidget);

namespace {
using Representation = vtkVisceraCutPlaneRepresentation;
/// Below the handles' widget, above the camera's style.
constexpr float kPriority = 0.4F;
} // namespace

vtkVisceraCutPlaneWidget::vtkVisceraCutPlaneWidget() {
  ManagesCursor = 0;
  KeyPressActivation = 0;
  Priority = kPriority;
  CallbackMapper->SetCallbackMethod(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::Select, this,
                                    PressAction);
  CallbackMapper->SetCallbackMethod(vtkCommand::LeftButtonReleaseEvent, vtkWidgetEvent::EndSelect, this,
                                    ReleaseAction);
  CallbackMapper->SetCallbackMethod(vtkCommand::MouseMoveEvent, vtkWidgetEvent::Move, this, MoveAction);
  CallbackMapper->SetCallbackMethod(vtkCommand::LeaveEvent, vtkWidgetEvent::HoverLeave, this, LeaveAction);
}

vtkVisceraCutPlaneWidget::~vtkVisceraCutPlaneWidget() = default;

void vtkVisceraCutPlaneWidget::PrintSelf(ostream& os, vtkIndent indent) {
  Superclass::PrintSelf(os, indent);
  os << indent << "Dragging: " << Dragging << "\n";
}

void vtkVisceraCutPlaneWidget::SetRepresentation(vtkVisceraCutPlaneRepresentation* representation) {
  CancelDrag();
  SetWidgetRepresentation(representation);
}

vtkVisceraCutPlaneRepresentation* vtkVisceraCutPlaneWidget::GetPlaneRepresentation() {
  return static_cast<Representation*>(GetRepresentation());
}

void vtkVisceraCutPlaneWidget::CreateDefaultRepresentation() {
  if (!WidgetRep)
    WidgetRep = Representation::New();
}

void vtkVisceraCutPlaneWidget::SetEnabled(int enabled) {
  if (!enabled)
    CancelDrag();
  Superclass::SetEnabled(enabled);
}

bool vtkVisceraCutPlaneWidget::IsUnderCursor() {
  return Dragging || (GetEnabled() && GetPlaneRepresentation()->GetHighlighted() != Representation::Outside);
}

void vtkVisceraCutPlaneWidget::SetHovered(int state) {
  auto* plane = GetPlaneRepresentation();
  if (plane->GetHighlighted() == state)
    return;
  plane->Highlight(state);
  InvokeEvent(vtkCommand::WidgetModifiedEvent);
}

void vtkVisceraCutPlaneWidget::PressAction(vtkAbstractWidget* widget) {
  auto* self = static_cast<vtkVisceraCutPlaneWidget*>(widget);
  const int* at = self->Interactor->GetEventPosition();
  if (self->Dragging || !self->CurrentRenderer || !self->CurrentRenderer->IsInViewport(at[0], at[1]))
    return;
  auto* plane = self->GetPlaneRepresentation();
  const int state = plane->ComputeInteractionState(at[0], at[1]);
  self->SetHovered(state);
  if (state == Representation::Outside)
    return;
  self->EventCallbackCommand->SetAbortFlag(1);
  double there[2] = {double(at[0]), double(at[1])};
  plane->StartWidgetInteraction(there);
  self->Dragging = true;
  self->GrabFocus(self->EventCallbackCommand);
  self->StartInteraction();
  self->InvokeEvent(vtkCommand::StartInteractionEvent);
}

void vtkVisceraCutPlaneWidget::MoveAction(vtkAbstractWidget* widget) {
  auto* self = static_cast<vtkVisceraCutPlaneWidget*>(widget);
  const int* at = self->Interactor->GetEventPosition();
  auto* plane = self->GetPlaneRepresentation();
  if (self->Dragging) {
    self->EventCallbackCommand->SetAbortFlag(1);
    double there[2] = {double(at[0]), double(at[1])};
    plane->WidgetInteraction(there);
    self->InvokeEvent(vtkCommand::InteractionEvent);
    return;
  }
  // While the camera is being moved nothing is under the cursor for long.
  auto* style = vtkInteractorStyle::SafeDownCast(self->Interactor->GetInteractorStyle());
  if (!style || style->GetState() == VTKIS_NONE)
    self->SetHovered(plane->ComputeInteractionState(at[0], at[1]));
}

void vtkVisceraCutPlaneWidget::LeaveAction(vtkAbstractWidget* widget) {
  auto* self = static_cast<vtkVisceraCutPlaneWidget*>(widget);
  if (!self->Dragging)
    self->SetHovered(Representation::Outside);
}

void vtkVisceraCutPlaneWidget::ReleaseAction(vtkAbstractWidget* widget) {
  auto* self = static_cast<vtkVisceraCutPlaneWidget*>(widget);
  if (!self->Dragging)
    return;
  self->EventCallbackCommand->SetAbortFlag(1);
  self->EndDrag();
}

void vtkVisceraCutPlaneWidget::CancelDrag() {
  if (!Dragging)
    return;
  GetPlaneRepresentation()->RestoreDrag();
  InvokeEvent(vtkCommand::InteractionEvent);
  EndDrag();
}

void vtkVisceraCutPlaneWidget::EndDrag() {
  Dragging = false;
  ReleaseFocus();
  EndInteraction();
  InvokeEvent(vtkCommand::EndInteractionEvent);
}
