#pragma once

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include "viscera/scene/theme.h"

namespace viscera::scene {

/// A 2D actor of lines and polygons in pixels in front of a view, rebuilt before a frame.
struct FlatShape {
  vtkNew<vtkPoints> points;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkActor2D> actor;

  FlatShape();

  /// `begin` clears all points; `end` tells VTK that there are new ones.
  void begin() { points->Reset(); }
  void end();
  vtkIdType add(double x, double y) { return points->InsertNextPoint(x, y, 0); }
  void addBox(double left, double bottom, double right, double top, vtkCellArray* polygons);
  void addDisc(double x, double y, double radius, int corners, vtkCellArray* polygons);
};

/// A text in the views' font; `size` in points at 72 DPI, that is logical pixels.
vtkSmartPointer<vtkTextActor> newText(int size);

/// Sets the size of a text, multiplied by the theme's type scale.
void setTextSize(vtkTextActor* text, double size, const Theme& theme);

} // namespace viscera::scene
