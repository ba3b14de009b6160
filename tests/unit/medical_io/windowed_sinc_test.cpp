#include "windowed_sinc.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include "shapes.h"
#include "viscera/geometry/volume.h"

/// Smoothing, with VTK's filter as an oracle.
namespace viscera::medical_io {
namespace {

Points smoothedByVtk(const geometry::TriangleMesh& mesh, int iterations, double passBand) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v)
    points->InsertNextPoint(mesh.points.row(v).data());
  vtkNew<vtkCellArray> triangles;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    triangles->InsertNextCell({mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2)});
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(triangles);
  vtkNew<vtkWindowedSincPolyDataFilter> filter;
  filter->SetInputData(data);
  filter->SetNumberOfIterations(iterations);
  filter->SetPassBand(passBand);
  filter->NormalizeCoordinatesOn();
  filter->BoundarySmoothingOff();
  filter->FeatureEdgeSmoothingOff();
  filter->NonManifoldSmoothingOn();
  filter->Update();
  Points smooth(mesh.points.rows(), 3);
  for (Eigen::Index v = 0; v < smooth.rows(); ++v)
    filter->GetOutput()->GetPoint(v, smooth.row(v).data());
  return smooth;
}

/// A sphere with steps, as from voxels.
geometry::TriangleMesh steppedSphere() {
  geometry::TriangleMesh mesh = tests::sphere(4, 30, {10, -200, 1000.0 / 3});
  mesh.points = mesh.points.array().round();
  return mesh;
}

void expectSmoothAsVtk(const geometry::TriangleMesh& mesh, int iterations, double passBand) {
  const geometry::TriangleMesh ours = smoothSurface(mesh, iterations, passBand);
  EXPECT_EQ(ours.triangles, mesh.triangles);
  EXPECT_LE((ours.points - smoothedByVtk(mesh, iterations, passBand)).cwiseAbs().maxCoeff(), 1e-9)
      << iterations << " " << passBand;
}

TEST(WindowedSinc, MovesPointsAsVtkDoes) {
  for (const int iterations : {2, 10, 20, 40})
    for (const double passBand : {0.01, 0.05, 0.1})
      expectSmoothAsVtk(steppedSphere(), iterations, passBand);
}

TEST(WindowedSinc, MovesPointsOfBordersAndOfFoldsAsVtkDoes) {
  geometry::TriangleMesh mesh = steppedSphere();
  const Eigen::Index whole = mesh.triangles.rows();
  mesh.triangles.conservativeResize(whole * 3 / 4, 3); // Leaves points that nothing uses.
  expectSmoothAsVtk(mesh, 20, 0.1);
  mesh.triangles.row(7) = mesh.triangles.row(90);
  mesh.triangles.row(200) = mesh.triangles.row(91);
  expectSmoothAsVtk(mesh, 20, 0.1);
}

TEST(WindowedSinc, TakesStepsAwayAndKeepsTheVolume) {
  const geometry::TriangleMesh rough = steppedSphere();
  const geometry::TriangleMesh smooth = smoothSurface(rough, 20, 0.1);
  const double before = geometry::volume(rough.points, rough.triangles);
  EXPECT_NEAR(geometry::volume(smooth.points, smooth.triangles), before, 0.01 * before);
  EXPECT_LT(geometry::area(smooth.points, smooth.triangles),
            0.99 * geometry::area(rough.points, rough.triangles));
}

TEST(WindowedSinc, LeavesASurfaceOfNothingAlone) {
  EXPECT_EQ(smoothSurface({}, 20, 0.1).points.rows(), 0);
}

} // namespace
} // namespace viscera::medical_io
