#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <vtkCommand.h>

#include "viscera/scene/vtkVisceraDragWidget.h"
#include "viscera/scene/widget_events.h"

class vtkVisceraHandleSetRepresentation;

/**
 * Handles the mouse on all handles of a view.
 *
 * Left drag moves the handle under the cursor, or the whole selection when it is part of it. A click selects
 * it alone; with Shift or Ctrl it joins or leaves the selection. Escape cancels a drag. Where no handle
 * is under the cursor the events go on to the camera. The widget never renders on a mouse
 * move that changes nothing.
 *
 * Events (call data: `viscera::scene::HandleEvent`), in the order of one drag:
 *
 *   HandleHoveredEvent    another handle, or none, is under the cursor
 *   SelectionChangedEvent only if the click changed it
 *   HandleGrabbedEvent    a drag has begun; its observers may set a constraint plane
 *   HandleMovedEvent      for every mouse move that changed positions; the listener may set other positions
 *   HandleReleasedEvent   the drag is over, or
 *   HandleCancelledEvent  it was cancelled: positions are restored, and one HandleMovedEvent came before
 *
 * VTK's own StartInteraction, Interaction and EndInteraction events come with them. Work for the next
 * frame (deforming, volume, chart) belongs into the observer of HandleMovedEvent; the widget renders after
 * it.
 */
class vtkVisceraHandleSetWidget : public vtkVisceraDragWidget {
public:
  static vtkVisceraHandleSetWidget* New();
  vtkTypeMacro(vtkVisceraHandleSetWidget, vtkVisceraDragWidget)

      enum {
        HandleHoveredEvent = vtkCommand::UserEvent + 7100,
        HandleGrabbedEvent,
        HandleMovedEvent,
        HandleReleasedEvent,
        HandleCancelledEvent,
        SelectionChangedEvent
      };

  void SetRepresentation(vtkVisceraHandleSetRepresentation* representation);
  vtkVisceraHandleSetRepresentation* GetHandleSet();
  void CreateDefaultRepresentation() override;

  /// Whether the widget asks the interactor to render after a change (on by default). Off: the observers
  /// render.
  vtkSetMacro(RenderOnChange, bool);
  /// Replaces the selection and notifies the observers if it has changed.
  void Select(std::vector<int> selection);

  ///@{
  /// Drags from another view that shows the same handles, such as a slice of a scan. They send the same
  /// events as the mouse in this view. `SetHovered` sets the handle under the cursor there (-1: none). `Grab`
  /// is a press on a handle, which selects it as a press here does (`extends`: with Shift or Ctrl), and
  /// returns whether a drag has begun; locked handles cannot be dragged. `plane` is the unit normal of the
  /// plane in which that mouse moves, for the observers. `DragTo` moves the handle to a place, mm, and the
  /// other dragged ones by the same vector. `Drop` ends the drag. `CancelDrag` restores all positions.
  void SetHovered(int handle);
  bool Grab(int handle, bool extends, const std::optional<viscera::Vec3>& plane = std::nullopt);
  void DragTo(const viscera::Vec3& position);
  void Drop();
  ///@}

protected:
  vtkVisceraHandleSetWidget();

  void Hover(int x, int y) override;
  void Leave() override;
  bool IsOverPart() override;
  void Press(int x, int y) override;
  void DragBegan() override;
  void Drag(int x, int y) override;
  void EndDrag(bool cancelled) override;

private:
  bool PressHandle(bool extends);
  void Follow(const std::function<void()>& move);
  void Tell(unsigned long event);
  void RenderAfterChange();

  bool RenderOnChange = true;
  bool Moved = false;
  bool AloneOnRelease = false;
  std::optional<viscera::Vec3> Plane; ///< Unit normal of the plane in which the present drag moves.
};
