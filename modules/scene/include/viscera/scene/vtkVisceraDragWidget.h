#pragma once

#include <vtkAbstractWidget.h>

/**
 * The base of our widgets, which drag parts of their representation: a left press grabs a part, moves drag
 * it, the release lets it go. Where no part of it is under the cursor the events go on to widgets of a
 * lower priority and to the camera; while the camera is being moved nothing is under the cursor.
 *
 * VTK's StartInteractionEvent, InteractionEvent and EndInteractionEvent tell of a drag.
 */
class vtkVisceraDragWidget : public vtkAbstractWidget {
public:
  vtkAbstractTypeMacro(vtkVisceraDragWidget, vtkAbstractWidget)

      /// Disabling cancels a drag.
      void SetEnabled(int enabled) override;

  bool IsDragging() const { return Dragging; }
  /// As Escape. Nothing happens when nothing is dragged.
  void CancelDrag();

protected:
  /// With `escape` the widget takes the keyboard during a drag, and Escape puts everything back.
  explicit vtkVisceraDragWidget(bool escape);

  /// Marks what is at a display position as under the cursor.
  virtual void Hover(int x, int y) = 0;
  /// The cursor has left the window.
  virtual void Leave() {}
  /// Whether something is under the cursor, as `Hover` found.
  virtual bool IsOverPart() = 0;
  /// A press on it: begins a drag unless somebody wants it otherwise.
  virtual void Press(int x, int y) { BeginDrag(x, y); }
  virtual void Drag(int x, int y);
  virtual void EndDrag(bool cancelled);
  /// It is in the hand, and nobody has been told yet.
  virtual void DragBegan() {}

  void BeginDrag(int x, int y);

  bool Dragging = false;

private:
  static void PressAction(vtkAbstractWidget* widget);
  static void MoveAction(vtkAbstractWidget* widget);
  static void ReleaseAction(vtkAbstractWidget* widget);
  static void LeaveAction(vtkAbstractWidget* widget);
  static void EscapeAction(vtkAbstractWidget* widget);

  bool Escape;
};
