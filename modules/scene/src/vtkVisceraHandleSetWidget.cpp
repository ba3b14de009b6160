#include "viscera/scene/vtkVisceraHandleSetWidget.h"

#include <cstring>

#include <vtkCallbackCommand.h>
#include <vtkEvent.h>
#include <vtkInteractorStyle.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkWidgetCallbackMapper.h>
#include <vtkWidgetEvent.h>

#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"

using viscera::scene::HandleEvent;

vtkStandardNewMacro(vtkVisceraHandleSetWidget);

vtkVisceraHandleSetWidget::vtkVisceraHandleSetWidget() {
  ManagesCursor = 0;
  KeyPressActivation = 0;
  CallbackMapper->SetCallbackMethod(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::Select, this,
                                    PressAction);
  CallbackMapper->SetCallbackMethod(vtkCommand::LeftButtonReleaseEvent, vtkWidgetEvent::EndSelect, this,
                                    ReleaseAction);
  CallbackMapper->SetCallbackMethod(vtkCommand::MouseMoveEvent, vtkWidgetEvent::Move, this, MoveAction);
  CallbackMapper->SetCallbackMethod(vtkCommand::LeaveEvent, vtkWidgetEvent::HoverLeave, this, LeaveAction);
  CallbackMapper->SetCallbackMethod(vtkCommand::KeyPressEvent, vtkEvent::AnyModifier, 0, 0, "Escape",
                                    vtkWidgetEvent::Reset, this, EscapeAction);
}

vtkVisceraHandleSetWidget::~vtkVisceraHandleSetWidget() = default;

void vtkVisceraHandleSetWidget::PrintSelf(ostream& os, vtkIndent indent) {
  Superclass::PrintSelf(os, indent);
  os << indent << "Dragging: " << Dragging << "\n";
  os << indent << "RenderOnChange: " << RenderOnChange << "\n";
}

void vtkVisceraHandleSetWidget::SetRepresentation(vtkVisceraHandleSetRepresentation* representation) {
  CancelDrag();
  SetWidgetRepresentation(representation);
}

vtkVisceraHandleSetRepresentation* vtkVisceraHandleSetWidget::GetHandleSet() {
  return static_cast<vtkVisceraHandleSetRepresentation*>(GetRepresentation());
}

void vtkVisceraHandleSetWidget::CreateDefaultRepresentation() {
  if (!WidgetRep)
    WidgetRep = vtkVisceraHandleSetRepresentation::New();
}

void vtkVisceraHandleSetWidget::SetEnabled(int enabled) {
  if (!enabled)
    CancelDrag();
  Superclass::SetEnabled(enabled);
}

void vtkVisceraHandleSetWidget::Tell(unsigned long event) {
  auto* handles = GetHandleSet();
  HandleEvent payload;
  payload.handle = handles->GetActiveHandle();
  payload.moving = Dragging ? handles->GetDraggedHandles() : handles->GetSelection();
  if (payload.handle >= 0)
    payload.position = payload.start = handles->GetPosition(payload.handle);
  for (std::size_t k = 0; Dragging && k < payload.moving.size(); ++k)
    if (payload.moving[k] == payload.handle)
      payload.start = handles->GetDragStart().row(Eigen::Index(k)).transpose();
  InvokeEvent(event, &payload);
}

void vtkVisceraHandleSetWidget::RenderAfterChange() {
  if (RenderOnChange)
    Render();
}

void vtkVisceraHandleSetWidget::Select(std::vector<int> selection) {
  auto* handles = GetHandleSet();
  const auto before = handles->GetSelection();
  handles->SetSelection(std::move(selection));
  if (handles->GetSelection() == before)
    return;
  Tell(SelectionChangedEvent);
  RenderAfterChange();
}

void vtkVisceraHandleSetWidget::PressAction(vtkAbstractWidget* widget) {
  auto* self = static_cast<vtkVisceraHandleSetWidget*>(widget);
  const int* at = self->Interactor->GetEventPosition();
  if (self->Dragging || !self->CurrentRenderer || !self->CurrentRenderer->IsInViewport(at[0], at[1]))
    return;
  self->Hover(at[0], at[1]);
  auto* handles = self->GetHandleSet();
  const int handle = handles->GetActiveHandle();
  if (handle < 0)
    return;
  self->EventCallbackCommand->SetAbortFlag(1);
  const bool extends = self->Interactor->GetShiftKey() || self->Interactor->GetControlKey();
  if (extends) {
    auto selection = handles->GetSelection();
    if (std::erase(selection, handle) == 0)
      selection.push_back(handle);
    self->Select(std::move(selection));
  } else if (!handles->IsSelected(handle)) {
    self->Select({handle});
  }
  self->Moved = false;
  self->AloneOnRelease = !extends;
  if (handles->GetActiveHandle() == handle && handles->IsSelected(handle) &&
      !handles->GetHandleLocked(handle))
    self->BeginDrag(at[0], at[1]);
}

void vtkVisceraHandleSetWidget::BeginDrag(int x, int y) {
  double at[2] = {double(x), double(y)};
  GetHandleSet()->StartWidgetInteraction(at);
  Dragging = true;
  GrabFocus(EventCallbackCommand, EventCallbackCommand);
  Superclass::StartInteraction();
  Tell(HandleGrabbedEvent);
  InvokeEvent(vtkCommand::StartInteractionEvent);
  RenderAfterChange();
}

void vtkVisceraHandleSetWidget::MoveAction(vtkAbstractWidget* widget) {
  auto* self = static_cast<vtkVisceraHandleSetWidget*>(widget);
  const int* at = self->Interactor->GetEventPosition();
  if (self->Dragging) {
    self->EventCallbackCommand->SetAbortFlag(1);
    self->Drag(at[0], at[1]);
    return;
  }
  // While the camera is being moved nothing is under the cursor for long.
  auto* style = vtkInteractorStyle::SafeDownCast(self->Interactor->GetInteractorStyle());
  if (style && style->GetState() != VTKIS_NONE)
    return;
  self->Hover(at[0], at[1]);
}

void vtkVisceraHandleSetWidget::LeaveAction(vtkAbstractWidget* widget) {
  auto* self = static_cast<vtkVisceraHandleSetWidget*>(widget);
  if (!self->Dragging)
    self->SetHovered(-1);
}

void vtkVisceraHandleSetWidget::Hover(int x, int y) {
  SetHovered(CurrentRenderer && CurrentRenderer->IsInViewport(x, y) ? GetHandleSet()->Pick(x, y) : -1);
}

void vtkVisceraHandleSetWidget::SetHovered(int handle) {
  auto* handles = GetHandleSet();
  if (handle == handles->GetActiveHandle())
    return;
  handles->SetActiveHandle(handle);
  Tell(HandleHoveredEvent);
  RenderAfterChange();
}

void vtkVisceraHandleSetWidget::Drag(int x, int y) {
  auto* handles = GetHandleSet();
  if (handles->GetDraggedHandles().empty()) { // The handles were replaced under the cursor.
    EndDrag(true);
    return;
  }
  const viscera::Vec3 before = handles->GetPosition(handles->GetActiveHandle());
  double at[2] = {double(x), double(y)};
  handles->WidgetInteraction(at);
  if (handles->GetPosition(handles->GetActiveHandle()) == before)
    return;
  Moved = true;
  Tell(HandleMovedEvent);
  InvokeEvent(vtkCommand::InteractionEvent);
  RenderAfterChange();
}

void vtkVisceraHandleSetWidget::ReleaseAction(vtkAbstractWidget* widget) {
  auto* self = static_cast<vtkVisceraHandleSetWidget*>(widget);
  if (!self->Dragging)
    return;
  self->EventCallbackCommand->SetAbortFlag(1);
  self->EndDrag(false);
}

void vtkVisceraHandleSetWidget::EscapeAction(vtkAbstractWidget* widget) {
  auto* self = static_cast<vtkVisceraHandleSetWidget*>(widget);
  // An event without a key symbol matches every symbol.
  const char* key = self->Interactor->GetKeySym();
  if (!self->Dragging || !key || std::strcmp(key, "Escape") != 0)
    return;
  self->EventCallbackCommand->SetAbortFlag(1);
  self->CancelDrag();
}

void vtkVisceraHandleSetWidget::CancelDrag() {
  if (Dragging)
    EndDrag(true);
}

void vtkVisceraHandleSetWidget::EndDrag(bool cancelled) {
  auto* handles = GetHandleSet();
  if (cancelled) {
    handles->RestoreDrag();
    if (Moved)
      Tell(HandleMovedEvent);
  }
  Tell(cancelled ? HandleCancelledEvent : HandleReleasedEvent);
  Dragging = false;
  ReleaseFocus();
  Superclass::EndInteraction();
  InvokeEvent(vtkCommand::EndInteractionEvent);
  if (!cancelled && !Moved && AloneOnRelease && handles->GetActiveHandle() >= 0)
    Select({handles->GetActiveHandle()});
  RenderAfterChange();
}
