#pragma once

#include <memory>
#include <vector>

#include <vtkWidgetRepresentation.h>

#include "viscera/core/arrays.h"
#include "viscera/scene/theme.h"

class vtkActor;

/**
 * Draws all handles of a view, finds the one under the cursor, and computes where a drag moves them.
 *
 * Handles are balls of constant size on the screen, in one glyph mapper. A handle behind an opaque occluder
 * is drawn as a ghost and is never picked; of several under the cursor the one nearest to the eye is. Sizes
 * are in logical pixels: they are multiplied by the window's DPI over 72, as QVTK sets it for high-density
 * screens. Display coordinates are VTK's: device pixels from the lower left corner.
 */
class vtkVisceraHandleSetRepresentation : public vtkWidgetRepresentation {
public:
  static vtkVisceraHandleSetRepresentation* New();
  vtkTypeMacro(vtkVisceraHandleSetRepresentation, vtkWidgetRepresentation)

      /// Interaction states: nothing, or a handle, under the cursor.
      enum {
        Outside = 0,
        OnHandle = 1
      };

  ///@{
  /// The handles, `n x 3` mm, n >= 0. Another count than before also resets colours, selection, locks and
  /// visibility.
  void SetPositions(viscera::Points positions);
  const viscera::Points& GetPositions() const;
  /// One handle; asserts that it exists.
  void SetPosition(int handle, const viscera::Vec3& position);
  viscera::Vec3 GetPosition(int handle) const;
  int GetNumberOfHandles() const;
  ///@}

  ///@{
  /// One colour for each handle (`n x 3`, usually its group's), or one for all.
  void SetColors(const viscera::Colors& colors);
  void SetColor(const viscera::Vec3& color);
  ///@}

  ///@{
  /// Handles that are not shown are not picked either; locked ones can be selected but not dragged.
  void SetHandleShown(int handle, bool shown);
  bool GetHandleShown(int handle) const;
  void SetHandleLocked(int handle, bool locked);
  bool GetHandleLocked(int handle) const;
  /// A handle in the background is drawn as small and pale as a far one, unless it is selected or under the
  /// cursor; it can still be picked.
  void SetHandleInBackground(int handle, bool background);
  bool GetHandleInBackground(int handle) const;
  ///@}

  ///@{
  /// Selected handles have a light rim. Ascending, without repetition; indices that do not exist are dropped.
  void SetSelection(std::vector<int> selection);
  const std::vector<int>& GetSelection() const;
  bool IsSelected(int handle) const;
  ///@}

  ///@{
  /// The handle under the cursor or being dragged, drawn a little larger; -1: none.
  void SetActiveHandle(int handle);
  int GetActiveHandle() const;
  ///@}

  ///@{
  /// Surfaces that hide handles, while they are visible and opaque. Triangles of a vtkPolyData; their
  /// transform has to be the identity; clipping planes of the mapper are respected.
  void AddOccluder(vtkActor* actor);
  void RemoveOccluder(vtkActor* actor);
  ///@}

  ///@{
  /// Picking at a display position: the visible handle nearest to the eye within the pick radius, or -1.
  /// O(n), and O(triangles) for each handle that is under the cursor.
  int PickHandle(int x, int y);
  /// Whether the centre of a handle is in front of the camera and not hidden. O(triangles).
  bool IsHandleVisible(int handle);
  ///@}

  ///@{
  /// Logical pixels: the radius of a handle (10), of the one under the cursor (12), and how far from its
  /// centre a handle can be picked (12).
  void SetHandleRadius(double pixels);
  double GetHandleRadius() const;
  void SetActiveRadius(double pixels);
  void SetPickRadius(double pixels);
  /// Rim colour, and the dark or light line around each handle.
  void SetTheme(const viscera::scene::Theme& theme);
  ///@}

  /// Radius of a handle in mm at its present place, as it is drawn in the renderer now.
  double GetWorldRadius(int handle);

  ///@{
  /// For the widget. A drag moves the active handle, and with it the selection when it belongs to it.
  /// `SolveDrag` computes the place of the active handle for a cursor position, parallel to the screen; it
  /// returns false for a handle behind the camera.
  void StartWidgetInteraction(double eventPosition[2]) override;
  void WidgetInteraction(double eventPosition[2]) override;
  bool SolveDrag(const double eventPosition[2], viscera::Vec3& position);
  /// Moves the active handle of the drag to a place, and the others by the same vector.
  void DragTo(const viscera::Vec3& position);
  /// The handles of the present drag, ascending, and where they were when it began (as many rows).
  const std::vector<int>& GetDraggedHandles() const;
  const viscera::Points& GetDragStart() const;
  /// Moves every handle of the drag back to its start.
  void RestoreDrag();
  ///@}

  // vtkWidgetRepresentation and vtkProp
  void SetRenderer(vtkRenderer* renderer) override;
  void BuildRepresentation() override;
  int ComputeInteractionState(int x, int y, int modify = 0) override;
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetActors(vtkPropCollection* collection) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  vtkTypeBool HasTranslucentPolygonalGeometry() override { return 0; }

protected:
  vtkVisceraHandleSetRepresentation();
  ~vtkVisceraHandleSetRepresentation() override;

private:
  struct Parts;
  std::unique_ptr<Parts> Internals;
};
