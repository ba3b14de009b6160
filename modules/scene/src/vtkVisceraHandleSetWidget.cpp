#include "viscera/scene/vtkVisceraHandleSetWidget.h"

#include <utility>

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"

using viscera::scene::HandleEvent;
using Representation = vtkVisceraHandleSetRepresentation;

vtkStandardNewMacro(vtkVisceraHandleSetWidget);

vtkVisceraHandleSetWidget::vtkVisceraHandleSetWidget() : vtkVisceraDragWidget(true) {}

void vtkVisceraHandleSetWidget::SetRepresentation(Representation* representation) {
  CancelDrag();
  SetWidgetRepresentation(representation);
}

Representation* vtkVisceraHandleSetWidget::GetHandleSet() {
  return static_cast<Representation*>(GetRepresentation());
}

void vtkVisceraHandleSetWidget::CreateDefaultRepresentation() {
  if (!WidgetRep)
    WidgetRep = Representation::New();
}

void vtkVisceraHandleSetWidget::Tell(unsigned long event) {
  auto* handles = GetHandleSet();
  HandleEvent payload;
  payload.handle = handles->GetActiveHandle();
  payload.moving = Dragging ? handles->GetDraggedHandles() : handles->GetSelection();
  if (Dragging)
    payload.plane = Plane;
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

bool vtkVisceraHandleSetWidget::IsOverPart() {
  return GetHandleSet()->GetActiveHandle() >= 0;
}

/// Selects as a press on the active handle does; whether it can be dragged.
bool vtkVisceraHandleSetWidget::PressHandle(bool extends) {
  auto* handles = GetHandleSet();
  const int handle = handles->GetActiveHandle();
  if (extends) {
    auto selection = handles->GetSelection();
    if (std::erase(selection, handle) == 0)
      selection.push_back(handle);
    Select(std::move(selection));
  } else if (!handles->IsSelected(handle)) {
    Select({handle});
  }
  Moved = false;
  AloneOnRelease = !extends;
  return handles->GetActiveHandle() == handle && handles->IsSelected(handle) &&
         !handles->GetHandleLocked(handle);
}

void vtkVisceraHandleSetWidget::Press(int x, int y) {
  if (!PressHandle(Interactor->GetShiftKey() || Interactor->GetControlKey()))
    return;
  Plane.reset();
  BeginDrag(x, y);
  RenderAfterChange();
}

bool vtkVisceraHandleSetWidget::Grab(int handle, bool extends, const std::optional<viscera::Vec3>& plane) {
  if (Dragging || !Enabled || handle < 0 || handle >= GetHandleSet()->GetNumberOfHandles())
    return false;
  SetHovered(handle);
  if (!PressHandle(extends))
    return false;
  Plane = plane;
  BeginDrag(0, 0); // Where this view's cursor is does not matter to `DragTo`.
  RenderAfterChange();
  return Dragging;
}

void vtkVisceraHandleSetWidget::DragTo(const viscera::Vec3& position) {
  if (Dragging)
    Follow([&] { GetHandleSet()->DragTo(position); });
}

void vtkVisceraHandleSetWidget::Drop() {
  if (Dragging)
    FinishDrag(false);
}

void vtkVisceraHandleSetWidget::DragBegan() {
  Tell(HandleGrabbedEvent);
}

void vtkVisceraHandleSetWidget::Leave() {
  SetHovered(-1);
}

void vtkVisceraHandleSetWidget::Hover(int x, int y) {
  SetHovered(CurrentRenderer && CurrentRenderer->IsInViewport(x, y) ? GetHandleSet()->PickHandle(x, y) : -1);
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
  Follow([&] {
    double at[2] = {double(x), double(y)};
    GetHandleSet()->WidgetInteraction(at);
  });
}

void vtkVisceraHandleSetWidget::Follow(const std::function<void()>& move) {
  auto* handles = GetHandleSet();
  if (handles->GetDraggedHandles().empty()) // The handles were replaced under the cursor.
    return FinishDrag(true);
  const viscera::Vec3 before = handles->GetPosition(handles->GetActiveHandle());
  move();
  if (handles->GetPosition(handles->GetActiveHandle()) == before)
    return;
  Moved = true;
  Tell(HandleMovedEvent);
  InvokeEvent(vtkCommand::InteractionEvent);
  RenderAfterChange();
}

void vtkVisceraHandleSetWidget::EndDrag(bool cancelled) {
  auto* handles = GetHandleSet();
  if (cancelled) {
    handles->RestoreDrag();
    if (Moved)
      Tell(HandleMovedEvent);
  }
  Tell(cancelled ? HandleCancelledEvent : HandleReleasedEvent);
  Superclass::EndDrag(cancelled);
  if (!cancelled && !Moved && AloneOnRelease && handles->GetActiveHandle() >= 0)
    Select({handles->GetActiveHandle()});
  RenderAfterChange();
}
