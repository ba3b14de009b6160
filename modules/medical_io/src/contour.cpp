#include "viscera/medical_io/contour.h"

#include <cassert>

#include <vtkAOSDataArrayTemplate.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

namespace viscera::medical_io {

template <class Value>
geometry::TriangleMesh contourOf(const std::vector<Value>& values, const std::array<int, 3>& size,
                                 double level, const Vec3& origin, double spacing) {
  assert(values.size() == std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]));
  vtkNew<vtkAOSDataArrayTemplate<Value>> scalars;
  // VTK only reads them; "1" leaves them to us.
  scalars->SetArray(const_cast<Value*>(values.data()), static_cast<vtkIdType>(values.size()), 1);
  vtkNew<vtkImageData> image;
  image->SetDimensions(size.data());
  image->SetSpacing(spacing, spacing, spacing);
  image->SetOrigin(origin.data());
  image->GetPointData()->SetScalars(scalars);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, level);
  contour->ComputeNormalsOff();
  contour->ComputeGradientsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  return meshOf(*contour->GetOutput());
}

template geometry::TriangleMesh contourOf(const std::vector<float>&, const std::array<int, 3>&, double,
                                          const Vec3&, double);
template geometry::TriangleMesh contourOf(const std::vector<unsigned char>&, const std::array<int, 3>&,
                                          double, const Vec3&, double);

geometry::TriangleMesh meshOf(vtkPolyData& data) {
  geometry::TriangleMesh mesh;
  mesh.points.resize(data.GetNumberOfPoints(), 3);
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i)
    data.GetPoint(i, mesh.points.row(i).data());
  mesh.triangles.resize(data.GetNumberOfPolys(), 3);
  vtkIdType count = 0, row = 0;
  const vtkIdType* corners = nullptr;
  const auto cells = vtk::TakeSmartPointer(data.GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell(), ++row) {
    cells->GetCurrentCell(count, corners);
    for (int k = 0; k < 3; ++k)
      mesh.triangles(row, k) = static_cast<std::int32_t>(corners[k]);
  }
  return mesh;
}

} // namespace viscera::medical_io
