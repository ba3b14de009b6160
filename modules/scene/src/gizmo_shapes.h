#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace viscera::scene {

/// Logical pixels, as the shapes are made.
inline constexpr double kGizmoRadius = 78;
inline constexpr double kGizmoArm = 104;
inline constexpr double kGizmoCube = 5;

/// The gizmo's parts about the origin, of lines and flat cubes; `axis` is 0, 1 or 2.
vtkSmartPointer<vtkPolyData> gizmoRing(int axis);
vtkSmartPointer<vtkPolyData> gizmoArm(int axis);
vtkSmartPointer<vtkPolyData> gizmoMiddle();

} // namespace viscera::scene
