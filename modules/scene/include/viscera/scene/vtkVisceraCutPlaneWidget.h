#pragma once

#include <vtkAbstractWidget.h>

class vtkVisceraCutPlaneRepresentation;

/**
 * Moves a cut plane with the mouse: left drag on its arrow pushes it, left drag on its rim tilts it; Escape
 * puts it back. Everywhere else the events go on to the camera. Handles in front of it go before it.
 *
 * VTK's StartInteractionEvent, InteractionEvent (for every move) and EndInteractionEvent tell of a drag;
 * HoverEvent (vtkCommand::WidgetModifiedEvent) of another look. The widget renders nothing itself.
 */
class vtkVisceraCutPlaneWidget : public vtkAbstractWidget {
public:
  static vtkVisceraCutPlaneWidget* New();
  vtkTypeMacro(vtkVisceraCutPlaneWidget, vtkAbstractWidget)

      void PrintSelf(ostream& os, vtkIndent indent) override;

  void SetRepresentation(vtkVisceraCutPlaneRepresentation* representation);
  vtkVisceraCutPlaneRepresentation* GetPlaneRepresentation();
  void CreateDefaultRepresentation() override;
  /// Disabling cancels a drag.
  void SetEnabled(int enabled) override;

  bool IsDragging() const { return Dragging; }
  /// Whether the plane is under the cursor or in the hand.
  bool IsUnderCursor();
  /// As Escape. Nothing happens when nothing is dragged.
  void CancelDrag();

protected:
  vtkVisceraCutPlaneWidget();
  ~vtkVisceraCutPlaneWidget() override;

private:
  vtkVisceraCutPlaneWidget(const vtkVisceraCutPlaneWidget&) = delete;
  void operator=(const vtkVisceraCutPlaneWidget&) = delete;

  static void PressAction(vtkAbstractWidget* widget);
  static void MoveAction(vtkAbstractWidget* widget);
  static void ReleaseAction(vtkAbstractWidget* widget);
  static void LeaveAction(vtkAbstractWidget* widget);
  void SetHovered(int state);
  void EndDrag();

  bool Dragging = false;
};
