#pragma once

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>

namespace viscera::scene {

/// A ball of radius 1 about the origin, with so many sides around it and from pole to pole.
inline vtkSmartPointer<vtkPolyData> unitBall(int sides) {
  vtkNew<vtkSphereSource> source;
  source->SetRadius(1);
  source->SetThetaResolution(sides);
  source->SetPhiResolution(sides);
  source->Update();
  return source->GetOutput();
}

} // namespace viscera::scene
