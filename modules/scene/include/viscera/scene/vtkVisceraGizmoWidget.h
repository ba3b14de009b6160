#pragma once

#include <vtkAbstractWidget.h>
#include <vtkCommand.h>

class vtkVisceraGizmoRepresentation;

/**
 * The mouse on a gizmo: a left drag on a part of it turns or scales. Escape during a drag puts everything
 * back. It goes before the handles under the cursor; where no part of it is, the events go on to them and to
 * the camera. The widget is enabled once and shown by its representation's visibility.
 *
 * Events (call data: `viscera::scene::GizmoEvent`): HoveredEvent when another part is under the cursor; then
 * GrabbedEvent, MovedEvent for every mouse move, and ReleasedEvent or CancelledEvent.
 */
class vtkVisceraGizmoWidget : public vtkAbstractWidget {
public:
  static vtkVisceraGizmoWidget* New();
  vtkTypeMacro(vtkVisceraGizmoWidget, vtkAbstractWidget)

      enum {
        HoveredEvent = vtkCommand::UserEvent + 7200,
        GrabbedEvent,
        MovedEvent,
        ReleasedEvent,
        CancelledEvent
      };

  void SetRepresentation(vtkVisceraGizmoRepresentation* representation);
  vtkVisceraGizmoRepresentation* GetGizmo();
  void CreateDefaultRepresentation() override;
  /// Disabling cancels a drag.
  void SetEnabled(int enabled) override;

  bool IsDragging() const { return Dragging; }
  /// As Escape. Nothing happens when nothing is dragged.
  void CancelDrag();

protected:
  vtkVisceraGizmoWidget();
  ~vtkVisceraGizmoWidget() override;

private:
  vtkVisceraGizmoWidget(const vtkVisceraGizmoWidget&) = delete;
  void operator=(const vtkVisceraGizmoWidget&) = delete;

  static void PressAction(vtkAbstractWidget* widget);
  static void MoveAction(vtkAbstractWidget* widget);
  static void ReleaseAction(vtkAbstractWidget* widget);
  static void EscapeAction(vtkAbstractWidget* widget);
  bool Shown();
  void Hover(int x, int y);
  void EndDrag(unsigned long event);
  void Tell(unsigned long event);

  bool Dragging = false;
};
