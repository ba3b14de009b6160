#include "viscera/scene/vtkVisceraDragWidget.h"

#include <cstring>

#include <vtkCallbackCommand.h>
#include <vtkEvent.h>
#include <vtkInteractorStyle.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkWidgetCallbackMapper.h>
#include <vtkWidgetEvent.h>
#include <vtkWidgetRepresentation.h>

vtkVisceraDragWidget::vtkVisceraDragWidget(bool escape) : Escape(escape) {
  ManagesCursor = 0;
  KeyPressActivation = 0;
  CallbackMapper->SetCallbackMethod(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::Select, this,
                                    PressAction);
  CallbackMapper->SetCallbackMethod(vtkCommand::LeftButtonReleaseEvent, vtkWidgetEvent::EndSelect, this,
                                    ReleaseAction);
  CallbackMapper->SetCallbackMethod(vtkCommand::MouseMoveEvent, vtkWidgetEvent::Move, this, MoveAction);
  CallbackMapper->SetCallbackMethod(vtkCommand::LeaveEvent, vtkWidgetEvent::HoverLeave, this, LeaveAction);
  if (escape)
    CallbackMapper->SetCallbackMethod(vtkCommand::KeyPressEvent, vtkEvent::AnyModifier, 0, 0, "Escape",
                                      vtkWidgetEvent::Reset, this, EscapeAction);
}

void vtkVisceraDragWidget::SetEnabled(int enabled) {
  if (!enabled)
    CancelDrag();
  Superclass::SetEnabled(enabled);
}

void vtkVisceraDragWidget::PressAction(vtkAbstractWidget* widget) {
  auto* self = static_cast<vtkVisceraDragWidget*>(widget);
  const int* at = self->Interactor->GetEventPosition();
  if (self->Dragging || !self->CurrentRenderer || !self->CurrentRenderer->IsInViewport(at[0], at[1]))
    return;
  self->Hover(at[0], at[1]);
  if (!self->IsOverPart())
    return;
  self->EventCallbackCommand->SetAbortFlag(1);
  self->Press(at[0], at[1]);
}

void vtkVisceraDragWidget::BeginDrag(int x, int y) {
  double at[2] = {double(x), double(y)};
  WidgetRep->StartWidgetInteraction(at);
  Dragging = true;
  GrabFocus(EventCallbackCommand, Escape ? EventCallbackCommand : nullptr);
  StartInteraction();
  DragBegan();
  InvokeEvent(vtkCommand::StartInteractionEvent);
}

void vtkVisceraDragWidget::MoveAction(vtkAbstractWidget* widget) {
  auto* self = static_cast<vtkVisceraDragWidget*>(widget);
  const int* at = self->Interactor->GetEventPosition();
  if (self->Dragging) {
    self->EventCallbackCommand->SetAbortFlag(1);
    return self->Drag(at[0], at[1]);
  }
  // While the camera is being moved nothing is under the cursor for long.
  auto* style = vtkInteractorStyle::SafeDownCast(self->Interactor->GetInteractorStyle());
  if (!style || style->GetState() == VTKIS_NONE)
    self->Hover(at[0], at[1]);
}

void vtkVisceraDragWidget::Drag(int x, int y) {
  double at[2] = {double(x), double(y)};
  WidgetRep->WidgetInteraction(at);
  InvokeEvent(vtkCommand::InteractionEvent);
}

void vtkVisceraDragWidget::LeaveAction(vtkAbstractWidget* widget) {
  auto* self = static_cast<vtkVisceraDragWidget*>(widget);
  if (!self->Dragging)
    self->Leave();
}

void vtkVisceraDragWidget::ReleaseAction(vtkAbstractWidget* widget) {
  auto* self = static_cast<vtkVisceraDragWidget*>(widget);
  if (!self->Dragging)
    return;
  self->EventCallbackCommand->SetAbortFlag(1);
  self->FinishDrag(false);
}

void vtkVisceraDragWidget::EscapeAction(vtkAbstractWidget* widget) {
  auto* self = static_cast<vtkVisceraDragWidget*>(widget);
  // An event without a key symbol matches every symbol.
  const char* key = self->Interactor->GetKeySym();
  if (!self->Dragging || !key || std::strcmp(key, "Escape") != 0)
    return;
  self->EventCallbackCommand->SetAbortFlag(1);
  self->CancelDrag();
}

void vtkVisceraDragWidget::CancelDrag() {
  if (Dragging)
    FinishDrag(true);
}

void vtkVisceraDragWidget::FinishDrag(bool cancelled) {
  if (Ending)
    return;
  Ending = true;
  EndDrag(cancelled);
  Ending = false;
}

void vtkVisceraDragWidget::EndDrag(bool) {
  Dragging = false;
  ReleaseFocus();
  EndInteraction();
  InvokeEvent(vtkCommand::EndInteractionEvent);
}
