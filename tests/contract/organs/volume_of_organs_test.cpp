#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkMassProperties.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include "organ_cases.h"
#include "viscera/geometry/volume.h"

namespace viscera::geometry {
namespace {

/// vtkMassProperties is right to about six digits: it weighs projections along three axes.
constexpr double kTheirAccuracy = 1e-5;

double volumeByVtk(const TriangleMesh& mesh) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (Eigen::Index i = 0; i < mesh.points.rows(); ++i)
    points->InsertNextPoint(mesh.points.row(i).data());
  vtkNew<vtkCellArray> triangles;
  for (Eigen::Index i = 0; i < mesh.triangles.rows(); ++i)
    triangles->InsertNextCell({mesh.triangles(i, 0), mesh.triangles(i, 1), mesh.triangles(i, 2)});
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(triangles);
  vtkNew<vtkMassProperties> properties;
  properties->SetInputData(data);
  return properties->GetVolume();
}

class VolumeOfOrgans : public testing::TestWithParam<tests::OrganCase> {};

TEST_P(VolumeOfOrgans, IsWhatVtkMeasuresWithinItsAccuracy) {
  const auto mesh = tests::load(GetParam());
  if (!mesh)
    GTEST_SKIP() << "../shared/organs/" << GetParam().file << " is not there";
  EXPECT_NEAR(volume(mesh->points, mesh->triangles) / volumeByVtk(*mesh), 1, kTheirAccuracy);
}

INSTANTIATE_TEST_SUITE_P(Organs, VolumeOfOrgans, testing::ValuesIn(tests::organCases()),
                         [](const auto& organ) { return organ.param.name; });

} // namespace
} // namespace viscera::geometry
