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

  /// The centre of the gizmo, mm.
  void SetCenter(const viscera::Vec3& center);
  const viscera::Vec3& GetCenter() const;

  void SetTheme(const viscera::scene::Theme& theme);

  /// The part under a display position. Cubes take precedence over rings.
  int PickPart(double x, double y) const;
  /// Sets the part that is highlighted, under the cursor or being dragged.
  void SetActivePart(int part);
  int GetActivePart() const;
  /// The best point to grab a part: the point of a ring nearest to the eye, or the middle of a cube, mm.
  viscera::Vec3 GetGrabPoint(int part) const;

  /// The rotation or scaling since `StartWidgetInteraction`.
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
