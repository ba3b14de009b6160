#include "vtk_poly_data.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include "viscera/medical_io/contour.h"

namespace viscera::medical_io {

vtkSmartPointer<vtkPolyData> polyDataOf(const geometry::TriangleMesh& mesh) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh.points.rows());
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v)
    points->SetPoint(v, mesh.points.row(v).data());

  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(mesh.triangles.rows(), 3 * mesh.triangles.rows());
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    triangles->InsertNextCell({mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2)});

  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(triangles);
  if (mesh.colors.rows() > 0) {
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetName("Colors");
    colors->SetNumberOfComponents(3);
    colors->SetNumberOfTuples(mesh.colors.rows());
    std::copy(mesh.colors.data(), mesh.colors.data() + mesh.colors.size(), colors->GetPointer(0));
    data->GetPointData()->SetScalars(colors);
  }
  return data;
}

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
  return meshOf(*filter->GetOutput());
}

} // namespace viscera::medical_io
