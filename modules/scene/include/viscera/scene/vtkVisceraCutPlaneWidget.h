#pragma once

#include "viscera/scene/vtkVisceraDragWidget.h"

class vtkVisceraCutPlaneRepresentation;

/**
 * Moves a cut plane with the mouse: left drag on its arrow pushes it, left drag on its rim tilts it; Escape
 * cancels the drag. Everywhere else the events go on to the camera. Handles in front of it take precedence.
 *
 * VTK's StartInteractionEvent, InteractionEvent (for every move) and EndInteractionEvent report a drag;
 * HoverEvent (vtkCommand::WidgetModifiedEvent) a change of the highlighted part. The widget does not render.
 */
class vtkVisceraCutPlaneWidget : public vtkVisceraDragWidget {
public:
  static vtkVisceraCutPlaneWidget* New();
  vtkTypeMacro(vtkVisceraCutPlaneWidget, vtkVisceraDragWidget)

      void SetRepresentation(vtkVisceraCutPlaneRepresentation* representation);
  vtkVisceraCutPlaneRepresentation* GetPlaneRepresentation();
  void CreateDefaultRepresentation() override;

  /// Whether the plane is under the cursor or being dragged.
  bool IsUnderCursor();

protected:
  vtkVisceraCutPlaneWidget();

  void Hover(int x, int y) override;
  void Leave() override;
  bool IsOverPart() override;
  void EndDrag(bool cancelled) override;

private:
  void SetHovered(int state);
};
