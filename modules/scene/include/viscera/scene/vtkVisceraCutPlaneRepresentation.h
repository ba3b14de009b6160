#pragma once

#include <memory>

#include <vtkWidgetRepresentation.h>

#include "viscera/core/arrays.h"
#include "viscera/scene/theme.h"
#include "viscera/scene/tissue_actor.h"

/**
 * Draws the grips of a cut plane and finds the one under the cursor: a thin rim in the plane around what is
 * cut, and an arrow out of its middle towards the side that is cut away. The arrow is pushed and pulled along
 * the normal; the rim tilts the plane about its middle. Nothing lies over the cut itself, so that it can be
 * seen, clicked and turned. Sizes are in logical pixels; display coordinates are VTK's.
 */
class vtkVisceraCutPlaneRepresentation : public vtkWidgetRepresentation {
public:
  static vtkVisceraCutPlaneRepresentation* New();
  vtkTypeMacro(vtkVisceraCutPlaneRepresentation, vtkWidgetRepresentation)

      /// Interaction states: the part under the cursor or being dragged.
      enum {
        Outside = 0,
        OnArrow = 1,
        OnRim = 2
      };

  ///@{
  /// The plane; the normal points to what stays and need not be unit.
  void SetPlane(const viscera::scene::CutPlane& plane);
  viscera::scene::CutPlane GetPlane() const;
  ///@}

  /// The ball around what is cut: middle and radius, mm. The rim lies about its middle's foot on the plane.
  void SetBall(const viscera::Vec3& center, double radius);
  /// The middle of the rim, where the arrow begins: mm.
  viscera::Vec3 GetMiddle() const;
  /// The end of the arrow, mm, and a place on the rim at an angle (rad): for tests and hints.
  viscera::Vec3 GetArrowTip() const;
  viscera::Vec3 GetRimPoint(double angle) const;

  void SetTheme(const viscera::scene::Theme& theme);
  /// Draws what is under the cursor more strongly.
  void Highlight(int state) override;
  int GetHighlighted() const;

  ///@{
  /// As VTK's widgets ask: what is at a display position; begin and continue a drag there.
  int ComputeInteractionState(int x, int y, int modify = 0) override;
  void StartWidgetInteraction(double at[2]) override;
  void WidgetInteraction(double at[2]) override;
  /// Puts the plane back to where the drag began.
  void RestoreDrag();
  ///@}

  void BuildRepresentation() override;
  void GetActors(vtkPropCollection* actors) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  double* GetBounds() override;

protected:
  vtkVisceraCutPlaneRepresentation();
  ~vtkVisceraCutPlaneRepresentation() override;

private:
  void Push(double x, double y);
  void Tilt(double x, double y);

  struct Parts;
  std::unique_ptr<Parts> Inside;
};
