#pragma once

#include <vtkCommand.h>

#include "viscera/scene/vtkVisceraDragWidget.h"

class vtkVisceraGizmoRepresentation;

/**
 * Handles the mouse on a gizmo: a left drag on a part of it turns or scales. Escape during a drag puts
 * everything back. It goes before the handles under the cursor; where no part of it is, the events go on to
 * them and to the camera. The widget is enabled once and shown by its representation's visibility.
 *
 * Events (call data: `viscera::scene::GizmoEvent`): HoveredEvent when another part is under the cursor; then
 * GrabbedEvent, MovedEvent for every mouse move, and ReleasedEvent or CancelledEvent.
 */
class vtkVisceraGizmoWidget : public vtkVisceraDragWidget {
public:
  static vtkVisceraGizmoWidget* New();
  vtkTypeMacro(vtkVisceraGizmoWidget, vtkVisceraDragWidget)

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
  void SetEnabled(int enabled) override;

protected:
  vtkVisceraGizmoWidget();

  void Hover(int x, int y) override;
  bool IsOverPart() override;
  void DragBegan() override;
  void Drag(int x, int y) override;
  void EndDrag(bool cancelled) override;

private:
  void Tell(unsigned long event);
};
