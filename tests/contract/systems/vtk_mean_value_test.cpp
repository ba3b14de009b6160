#include <vtkCellArray.h>
#include <vtkIdTypeArray.h>
#include <vtkMeanValueCoordinatesInterpolator.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <gtest/gtest.h>

#include "clouds.h"
#include "viscera/coordinates/systems.h"
#include "viscera/geometry/convex_hull.h"

namespace viscera::coordinates {
namespace {

/// VTK's own implementation as an oracle.
TEST(MeanValueOracle, AgreesWithVtkInsideACage) {
  HandleSet handles;
  handles.positions = tests::onSphere(30, 50);
  handles.cage = geometry::ConvexHull(handles.positions).triangles();
  const Points points = tests::cloud(1000, 4, 25);
  Progress progress;
  const auto binding = meanValue()->bind(handles, points, {}, progress);

  vtkNew<vtkPoints> corners;
  corners->SetDataTypeToDouble();
  for (Eigen::Index i = 0; i < handles.positions.rows(); ++i)
    corners->InsertNextPoint(handles.positions.row(i).data());
  vtkNew<vtkCellArray> triangles;
  for (Eigen::Index i = 0; i < handles.cage.rows(); ++i)
    triangles->InsertNextCell({handles.cage(i, 0), handles.cage(i, 1), handles.cage(i, 2)});

  std::vector<Values> ours;
  for (int i = 0; i < 30; ++i)
    ours.push_back(binding->influence(i));
  for (Eigen::Index p = 0; p < points.rows(); ++p) {
    double theirs[30];
    vtkMeanValueCoordinatesInterpolator::ComputeInterpolationWeights(points.row(p).data(), corners, triangles,
                                                                     theirs);
    for (std::size_t i = 0; i < ours.size(); ++i)
      ASSERT_NEAR(ours[i][p], theirs[i], 1e-9) << "point " << p << ", handle " << i;
  }
}

} // namespace
} // namespace viscera::coordinates
