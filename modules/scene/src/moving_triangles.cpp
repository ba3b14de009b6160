#include "moving_triangles.h"

#include <algorithm>

#include <vtkCellArray.h>
#include <vtkDecimatePro.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include "viscera/geometry/coarse_triangles.h"

namespace viscera::scene {
namespace {

constexpr Eigen::Index kFewest = 300; ///< Vertices, or a surface loses its shape.
constexpr Eigen::Index kSmall = 20000;
constexpr double kSharp = 30; ///< Degrees between triangles at a rim.
constexpr const char* kRows = "rows";

vtkSmartPointer<vtkPolyData> withRows(const geometry::TriangleMesh& mesh) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIdTypeArray> rows;
  rows->SetName(kRows);
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v) {
    points->InsertNextPoint(mesh.points(v, 0), mesh.points(v, 1), mesh.points(v, 2));
    rows->InsertNextValue(v);
  }
  vtkNew<vtkCellArray> cells;
  for (const auto& triangle : mesh.triangles.rowwise())
    cells->InsertNextCell({triangle[0], triangle[1], triangle[2]});
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetPointData()->AddArray(rows);
  return data;
}

/// Half of the triangles. Every vertex of the result is one of the surface.
Triangles half(const geometry::TriangleMesh& mesh) {
  vtkNew<vtkDecimatePro> decimate;
  decimate->SetInputData(withRows(mesh));
  decimate->SetTargetReduction(0.5);
  decimate->SetFeatureAngle(kSharp);
  decimate->PreserveTopologyOn();
  decimate->SplittingOff();
  decimate->Update();
  vtkPolyData* found = decimate->GetOutput();
  auto* rows = vtkIdTypeArray::SafeDownCast(found->GetPointData()->GetArray(kRows));
  Triangles triangles(found->GetNumberOfPolys(), 3);
  for (vtkIdType t = 0; t < found->GetNumberOfPolys(); ++t) {
    const vtkIdType* corners = nullptr;
    vtkIdType count = 0;
    found->GetPolys()->GetCellAtId(t, count, corners);
    for (int corner = 0; corner < 3; ++corner)
      triangles(t, corner) = static_cast<std::int32_t>(rows->GetValue(corners[corner]));
  }
  return triangles;
}

} // namespace

Triangles movingTriangles(const geometry::TriangleMesh& mesh, int part) {
  const Eigen::Index vertices = mesh.points.rows();
  if (part == 2 && vertices >= 2 * kFewest && vertices <= kSmall)
    return half(mesh);
  return geometry::coarseTriangles(mesh, std::max(kFewest, vertices / part));
}

} // namespace viscera::scene
