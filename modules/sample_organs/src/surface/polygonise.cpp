#include "surface/polygonise.h"

#include <algorithm>
#include <vector>

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "surface/sample_grid.h"
#include "viscera/core/error.h"
#include "viscera/geometry/connected_pieces.h"
#include "viscera/geometry/surface_check.h"

namespace viscera::sample_organs {
namespace {

using geometry::TriangleMesh;

vtkNew<vtkPolyData> contoured(SampleGrid& grid) {
  vtkNew<vtkFloatArray> values;
  values->SetArray(grid.values.data(), static_cast<vtkIdType>(grid.values.size()), 1);
  vtkNew<vtkImageData> image;
  image->SetDimensions(grid.size.data());
  image->SetSpacing(grid.spacing, grid.spacing, grid.spacing);
  image->SetOrigin(grid.origin.data());
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, 0.0);
  contour->ComputeNormalsOff();
  contour->ComputeGradientsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  vtkNew<vtkPolyData> result;
  result->ShallowCopy(contour->GetOutput());
  return result;
}

TriangleMesh meshOf(vtkPolyData& data) {
  TriangleMesh mesh;
  mesh.points.resize(data.GetNumberOfPoints(), 3);
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i)
    data.GetPoint(i, mesh.points.row(i).data());
  mesh.triangles.resize(data.GetNumberOfPolys(), 3);
  vtkIdType count = 0;
  const vtkIdType* corners = nullptr;
  vtkIdType row = 0;
  const auto cells = vtk::TakeSmartPointer(data.GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell(), ++row) {
    cells->GetCurrentCell(count, corners);
    for (int k = 0; k < 3; ++k)
      mesh.triangles(row, k) = static_cast<std::int32_t>(corners[k]);
  }
  return mesh;
}

/// The piece with the most triangles, points in the order in which triangles name them.
TriangleMesh largestPart(const TriangleMesh& mesh) {
  const auto [count, piece] = geometry::connectedPieces(mesh);
  std::vector<int> size(static_cast<std::size_t>(count), 0);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    ++size[static_cast<std::size_t>(piece[static_cast<std::size_t>(mesh.triangles(t, 0))])];
  const auto largest = static_cast<std::int32_t>(std::max_element(size.begin(), size.end()) - size.begin());

  TriangleMesh result;
  std::vector<std::int32_t> renamed(piece.size(), -1);
  std::int32_t points = 0;
  Eigen::Index triangles = 0;
  result.points.resize(mesh.points.rows(), 3);
  result.triangles.resize(mesh.triangles.rows(), 3);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    if (piece[static_cast<std::size_t>(mesh.triangles(t, 0))] != largest)
      continue;
    for (int k = 0; k < 3; ++k) {
      std::int32_t& name = renamed[static_cast<std::size_t>(mesh.triangles(t, k))];
      if (name < 0) {
        name = points++;
        result.points.row(name) = mesh.points.row(mesh.triangles(t, k));
      }
      result.triangles(triangles, k) = name;
    }
    ++triangles;
  }
  result.points.conservativeResize(points, 3);
  result.triangles.conservativeResize(triangles, 3);
  return result;
}

} // namespace

TriangleMesh polygonise(const ImplicitNode& node, double spacing, Threads threads,
                        const ProgressSpan& progress) {
  SampleGrid grid = sampleGrid(node, spacing, threads, progress);
  const vtkNew<vtkPolyData> contour = contoured(grid);
  if (contour->GetNumberOfPolys() == 0)
    throw DataError("the implicit surface is empty", {},
                    "check that its parts meet and that \"spacing\" is fine enough");
  TriangleMesh mesh = largestPart(meshOf(*contour));
  geometry::orientOutward(mesh);
  return mesh;
}

} // namespace viscera::sample_organs
