#include "smooth_surface.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include "viscera/contour/contour.h"
#include "vtk_poly_data.h"

namespace viscera::medical_io {

geometry::TriangleMesh smoothSurface(const geometry::TriangleMesh& mesh, int iterations, double passBand) {
  vtkNew<vtkWindowedSincPolyDataFilter> filter;
  filter->SetInputData(polyDataOf(mesh));
  filter->SetNumberOfIterations(iterations);
  filter->SetPassBand(passBand);
  filter->NormalizeCoordinatesOn();
  filter->BoundarySmoothingOff();
  filter->FeatureEdgeSmoothingOff();
  filter->NonManifoldSmoothingOn();
  filter->Update();
  return contour::meshOf(*filter->GetOutput());
}

} // namespace viscera::medical_io
