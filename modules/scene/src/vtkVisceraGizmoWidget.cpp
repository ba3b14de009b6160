#include "viscera/scene/vtkVisceraGizmoWidget.h"

#include <vtkObjectFactory.h>
#include <vtkRenderer.h>

#include "viscera/scene/vtkVisceraGizmoRepresentation.h"

vtkStandardNewMacro(vtkVisceraGizmoWidget);

namespace {
using GizmoRepresentation = vtkVisceraGizmoRepresentation;
/// Above the handles' widget, which has VTK's standard one.
constexpr float kGizmoPriority = 0.6F;
} // namespace

vtkVisceraGizmoWidget::vtkVisceraGizmoWidget() : vtkVisceraDragWidget(true) {
  Priority = kGizmoPriority;
}

void vtkVisceraGizmoWidget::SetRepresentation(GizmoRepresentation* representation) {
  CancelDrag();
  SetWidgetRepresentation(representation);
}

GizmoRepresentation* vtkVisceraGizmoWidget::GetGizmo() {
  return static_cast<GizmoRepresentation*>(GetRepresentation());
}

void vtkVisceraGizmoWidget::CreateDefaultRepresentation() {
  if (!WidgetRep)
    WidgetRep = GizmoRepresentation::New();
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

void vtkVisceraGizmoWidget::Tell(unsigned long event) {
  viscera::scene::GizmoEvent payload = GetGizmo()->GetMotion();
  InvokeEvent(event, &payload);
}

void vtkVisceraGizmoWidget::Hover(int x, int y) {
  auto* gizmo = GetGizmo();
  const bool shown = gizmo->GetVisibility() && CurrentRenderer && CurrentRenderer->IsInViewport(x, y);
  const int part = shown ? gizmo->PickPart(x, y) : GizmoRepresentation::Nothing;
  if (part == gizmo->GetActivePart())
    return;
  gizmo->SetActivePart(part);
  Tell(HoveredEvent);
}

bool vtkVisceraGizmoWidget::IsOverPart() {
  return GetGizmo()->GetActivePart() != GizmoRepresentation::Nothing;
}

void vtkVisceraGizmoWidget::DragBegan() {
  Tell(GrabbedEvent);
}

void vtkVisceraGizmoWidget::Drag(int x, int y) {
  double at[2] = {double(x), double(y)};
  GetGizmo()->WidgetInteraction(at);
  Tell(MovedEvent);
  InvokeEvent(vtkCommand::InteractionEvent);
}

void vtkVisceraGizmoWidget::EndDrag(bool cancelled) {
  // An observer may move the gizmo, so the drag is over before the event is sent.
  Dragging = false;
  ReleaseFocus();
  Tell(cancelled ? CancelledEvent : ReleasedEvent);
  Superclass::EndDrag(cancelled);
}
