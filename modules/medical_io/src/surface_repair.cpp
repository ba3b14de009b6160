#include "viscera/medical_io/surface_repair.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkQuadricDecimation.h>

#include "smooth_surface.h"
#include "viscera/core/error.h"
#include "viscera/geometry/clean_surface.h"
#include "viscera/geometry/connected_pieces.h"
#include "viscera/geometry/signed_distance_grid.h"
#include "viscera/geometry/surface_check.h"
#include "vtk_poly_data.h"

namespace viscera::medical_io {
namespace {

using geometry::TriangleMesh;

/// Edge of the clusters that triangles are merged to before distances are measured, by the grid's spacing.
constexpr double kClusterScale = 0.5;
constexpr int kSmoothingRounds = 2;
constexpr double kSmallestPiece = 0.01; ///< Of the whole volume.
/// Of the contour, whose triangles are the grid's, and then of the thinned surface.
constexpr int kFirstIterations = 20, kSecondIterations = 10;
constexpr double kFirstPassBand = 0.05, kSecondPassBand = 0.1;

TriangleMesh zeroLevel(geometry::SignedDistanceGrid& grid) {
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
  return meshOf(*contour->GetOutput());
}

/// Drops what is too small to matter, cavities as well as crumbs.
TriangleMesh withoutCrumbs(TriangleMesh mesh) {
  const auto [count, piece] = geometry::connectedPieces(mesh);
  const Vec3 middle = boundsOf(mesh.points).center();
  std::vector<double> volumes(static_cast<std::size_t>(count), 0.0);
  const auto corner = [&](Eigen::Index t, int k) -> Vec3 {
    return mesh.points.row(mesh.triangles(t, k)).transpose() - middle;
  };
  double total = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const double part = corner(t, 0).dot(corner(t, 1).cross(corner(t, 2))) / 6;
    volumes[static_cast<std::size_t>(piece[static_cast<std::size_t>(mesh.triangles(t, 0))])] += part;
    total += part;
  }
  Eigen::Index kept = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    if (std::abs(volumes[static_cast<std::size_t>(piece[static_cast<std::size_t>(mesh.triangles(t, 0))])]) >=
        kSmallestPiece * std::abs(total))
      mesh.triangles.row(kept++) = mesh.triangles.row(t).eval();
  mesh.triangles.conservativeResize(kept, 3);
  return mesh;
}

} // namespace

TriangleMesh repairSurface(const TriangleMesh& mesh, const RepairOptions& options, Progress& progress,
                           Threads threads) {
  const Bounds box = boundsOf(mesh.points);
  const double spacing = (box.high - box.low).maxCoeff() / options.cells;
  if (mesh.triangles.rows() == 0 || !(spacing > 0))
    throw DataError("the surface has no triangles or no size", "surface");
  const TriangleMesh coarse = geometry::clusterVertices(mesh, kClusterScale * spacing);
  geometry::SignedDistanceGrid grid = geometry::signedDistanceGrid(coarse, spacing, progress, threads);
  geometry::smoothen(grid, kSmoothingRounds, threads);
  progress.throwIfCancelled();
  TriangleMesh result = withoutCrumbs(zeroLevel(grid));
  if (result.triangles.rows() == 0)
    throw DataError("the surface encloses nothing", "surface",
                    "check that its triangles face outward and that its holes are small");
  result = smoothSurface(result, kFirstIterations, kFirstPassBand);
  result = thinSurface(result, options.triangles);
  progress.throwIfCancelled();
  return geometry::cleanSurface(smoothSurface(result, kSecondIterations, kSecondPassBand)).mesh;
}

TriangleMesh thinSurface(const TriangleMesh& mesh, int triangles) {
  if (mesh.triangles.rows() <= triangles)
    return mesh;
  vtkNew<vtkQuadricDecimation> decimation;
  decimation->SetInputData(polyDataOf({mesh.points, mesh.triangles, {}}));
  decimation->SetTargetReduction(1 - static_cast<double>(triangles) / double(mesh.triangles.rows()));
  decimation->VolumePreservationOn();
  decimation->Update();
  return geometry::cleanSurface(meshOf(*decimation->GetOutput())).mesh;
}

} // namespace viscera::medical_io
