#include "viscera/scene/vtkVisceraCutPlaneWidget.h"

#include <vtkCommand.h>
#include <vtkObjectFactory.h>

#include "viscera/scene/vtkVisceraCutPlaneRepresentation.h"

vtkStandardNewMacro(vtkVisceraCutPlaneWidget);

namespace {
using CutPlaneRepresentation = vtkVisceraCutPlaneRepresentation;
/// Below the handles' widget, above the camera's style.
constexpr float kCutPlanePriority = 0.4F;
} // namespace

vtkVisceraCutPlaneWidget::vtkVisceraCutPlaneWidget() : vtkVisceraDragWidget(false) {
  Priority = kCutPlanePriority;
}

void vtkVisceraCutPlaneWidget::SetRepresentation(CutPlaneRepresentation* representation) {
  CancelDrag();
  SetWidgetRepresentation(representation);
}

CutPlaneRepresentation* vtkVisceraCutPlaneWidget::GetPlaneRepresentation() {
  return static_cast<CutPlaneRepresentation*>(GetRepresentation());
}

void vtkVisceraCutPlaneWidget::CreateDefaultRepresentation() {
  if (!WidgetRep)
    WidgetRep = CutPlaneRepresentation::New();
}

bool vtkVisceraCutPlaneWidget::IsUnderCursor() {
  return Dragging || (GetEnabled() && IsOverPart());
}

bool vtkVisceraCutPlaneWidget::IsOverPart() {
  return GetPlaneRepresentation()->GetHighlighted() != CutPlaneRepresentation::Outside;
}

void vtkVisceraCutPlaneWidget::SetHovered(int state) {
  auto* plane = GetPlaneRepresentation();
  if (plane->GetHighlighted() == state)
    return;
  plane->Highlight(state);
  InvokeEvent(vtkCommand::WidgetModifiedEvent);
}

void vtkVisceraCutPlaneWidget::Hover(int x, int y) {
  SetHovered(GetPlaneRepresentation()->ComputeInteractionState(x, y));
}

void vtkVisceraCutPlaneWidget::Leave() {
  SetHovered(CutPlaneRepresentation::Outside);
}

void vtkVisceraCutPlaneWidget::EndDrag(bool cancelled) {
  if (cancelled) {
    GetPlaneRepresentation()->RestoreDrag();
    InvokeEvent(vtkCommand::InteractionEvent);
  }
  Superclass::EndDrag(cancelled);
}
