#pragma once

#include <vtkAbstractWidget.h>

/**
 * The base class of our widgets, which drag parts of their representation: a left press grabs a part, moves
 * drag it, the release ends the drag. Where no part of it is under the cursor the events go on to widgets of
 * a lower priority and to the camera; while the camera is being moved, no part counts as under the cursor.
 *
 * VTK's StartInteractionEvent, InteractionEvent and EndInteractionEvent report a drag.
 */
class vtkVisceraDragWidget : public vtkAbstractWidget {
public:
  vtkAbstractTypeMacro(vtkVisceraDragWidget, vtkAbstractWidget)

      /// Disabling cancels a drag.
      void SetEnabled(int enabled) override;

  bool IsDragging() const { return Dragging; }
  /// Cancels the drag, like the Escape key. Nothing happens when nothing is dragged.
  void CancelDrag();

protected:
  /// The widget handles the keyboard during a drag with `escape`, and Escape cancels the drag.
  explicit vtkVisceraDragWidget(bool escape);

  /// Marks what is at a display position as under the cursor.
  virtual void Hover(int x, int y) = 0;
  /// The cursor has left the window.
  virtual void Leave() {}
  /// Whether the last `Hover` found a part under the cursor.
  virtual bool IsOverPart() = 0;
  /// Called for a press on a part. Begins a drag unless a subclass overrides it.
  virtual void Press(int x, int y) { BeginDrag(x, y); }
  virtual void Drag(int x, int y);
  /// Ends a drag; called by `FinishDrag` alone.
  virtual void EndDrag(bool cancelled);
  /// Called when a drag has begun, before its first event is sent.
  virtual void DragBegan() {}

  void BeginDrag(int x, int y);
  /// Calls `EndDrag`, once for each drag, even when an observer of its last events cancels the drag.
  void FinishDrag(bool cancelled);

  bool Dragging = false;

private:
  static void PressAction(vtkAbstractWidget* widget);
  static void MoveAction(vtkAbstractWidget* widget);
  static void ReleaseAction(vtkAbstractWidget* widget);
  static void LeaveAction(vtkAbstractWidget* widget);
  static void EscapeAction(vtkAbstractWidget* widget);

  bool Escape;
  bool Ending = false; ///< `EndDrag` is under way.
};
