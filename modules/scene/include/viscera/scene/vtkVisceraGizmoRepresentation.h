#pragma once

#include <memory>

#include <vtkWidgetRepresentation.h>

#include "viscera/core/arrays.h"
#include "viscera/scene/theme.h"
#include "viscera/scene/widget_events.h"

/**
 * Draws a gizmo to turn and scale things about a centre: a ring around each of the patient's axes turns, a
 * cube at the end of each axis scales along it, the cube in the middle scales evenly.
 *
 * It keeps its size on the screen. What lies behind an organ is drawn fainter, and can be grabbed all the
 * same. A ring that is seen from its side turns by the motion along it, any other by the angle of the cursor
 * around its middle. Display coordinates are VTK's: device pixels from the lower left corner.
 */
class vtkVisceraGizmoRepresentation : public vtkWidgetRepresentation {
public:
  static vtkVisceraGizmoRepresentation* New();
  vtkTypeMacro(vtkVisceraGizmoRepresentation, vtkWidgetRepresentation)

      /// The parts, also as interaction states.
      enum Part {
        Nothing = 0,
        RingX,
        RingY,
        RingZ,
        CubeX,
        CubeY,
        CubeZ,
        Middle
      };

  /// Where it stands, mm.
  void SetCenter(const viscera::Vec3& center);
  const viscera::Vec3& GetCenter() const;

  void SetTheme(const viscera::scene::Theme& theme);

  /// The part under a display position. Cubes go before rings.
  int Pick(double x, double y) const;
  /// The part that is drawn as under the cursor or in the hand.
  void SetActivePart(int part);
  int GetActivePart() const;
  /// Where a part is grabbed best: the nearest point to the eye of a ring, the middle of a cube, mm.
  viscera::Vec3 GetGrabPoint(int part) const;

  /// What the drag has done since `StartWidgetInteraction`.
  const viscera::scene::GizmoEvent& GetMotion() const;

  // vtkWidgetRepresentation and vtkProp
  void StartWidgetInteraction(double eventPosition[2]) override;
  void WidgetInteraction(double eventPosition[2]) override;
  int ComputeInteractionState(int x, int y, int modify = 0) override;
  void BuildRepresentation() override;
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetActors(vtkPropCollection* collection) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  vtkTypeBool HasTranslucentPolygonalGeometry() override { return 0; }

protected:
  vtkVisceraGizmoRepresentation();
  ~vtkVisceraGizmoRepresentation() override;

private:
  struct Parts;
  std::unique_ptr<Parts> Internals;
};
