#include "viscera/medical_io/label_surfaces.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include <vtkDecimatePro.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include "file_bytes.h"
#include "smooth_surface.h"
#include "viscera/core/error.h"
#include "viscera/geometry/normals.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/geometry/volume.h"
#include "viscera/medical_io/surface_repair.h"
#include "voxel_pieces.h"
#include "vtk_poly_data.h"

namespace viscera::medical_io {
namespace {

using geometry::TriangleMesh;

/// How much smoother one unit of `LabelSurfaceOptions::smoothing` makes the surface.
constexpr int kFewestIterations = 20, kIterationsPerUnit = 20;
constexpr double kPassBandPerUnit = 0.01;
/// A label that smoothing spoils is tried again with these parts of it.
constexpr std::array<double, 3> kTries = {1, 0.25, 0};
/// The volume is corrected until it is this close, relative to the voxels'.
constexpr double kCorrectedWithin = 1e-4;
constexpr int kMostCorrections = 20;

/// The steps between the voxels, in mm LPS, outward.
TriangleMesh contourOf(VoxelBox& box, const LabelMap& map) {
  vtkNew<vtkUnsignedCharArray> values;
  values->SetArray(box.inside.data(), static_cast<vtkIdType>(box.inside.size()), 1);
  vtkNew<vtkImageData> image;
  image->SetDimensions(box.size.data());
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, 0.5);
  contour->ComputeNormalsOff();
  contour->ComputeGradientsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  TriangleMesh mesh = meshOf(*contour->GetOutput());
  const Vec3 low(box.low[0], box.low[1], box.low[2]);
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v)
    mesh.points.row(v) = (map.indexToLps * (mesh.points.row(v).transpose() + low)).transpose();
  // A left-handed grid turns the triangles around.
  geometry::orientOutward(mesh);
  return mesh;
}

TriangleMesh smoothed(const TriangleMesh& mesh, double smoothing) {
  if (smoothing <= 0)
    return mesh;
  return smoothSurface(mesh, kFewestIterations + static_cast<int>(kIterationsPerUnit * smoothing),
                       std::pow(kPassBandPerUnit, smoothing));
}

bool isSound(const TriangleMesh& mesh) {
  const geometry::SurfaceReport report = geometry::checkSurface(mesh);
  return report.closed() && report.manifold() && report.volumeMm3 > 0;
}

/// Removes only vertices whose removal leaves the topology as it is; so it may end with more triangles.
TriangleMesh thinnedByVertices(const TriangleMesh& mesh, int triangles) {
  vtkNew<vtkDecimatePro> decimation;
  decimation->SetInputData(polyDataOf(mesh));
  decimation->SetTargetReduction(1 -
                                 static_cast<double>(triangles) / static_cast<double>(mesh.triangles.rows()));
  decimation->PreserveTopologyOn();
  decimation->SplittingOff();
  decimation->BoundaryVertexDeletionOff();
  decimation->Update();
  return meshOf(*decimation->GetOutput());
}

TriangleMesh thinned(const TriangleMesh& mesh, int triangles) {
  if (triangles == 0 || mesh.triangles.rows() <= triangles)
    return mesh;
  TriangleMesh thin = thinSurface(mesh, triangles);
  return isSound(thin) ? thin : thinnedByVertices(mesh, triangles);
}

/// Moves all vertices along their normals until the surface encloses `target` mm^3.
void correctVolume(TriangleMesh& mesh, double target) {
  const geometry::VertexTriangles around = geometry::vertexTriangles(mesh.points.rows(), mesh.triangles);
  geometry::Normals normals;
  for (int i = 0; i < kMostCorrections; ++i) {
    const double missing = target - geometry::volume(mesh.points, mesh.triangles, Threads{1});
    if (std::abs(missing) <= kCorrectedWithin * target)
      return;
    geometry::vertexNormals(mesh.points, mesh.triangles, around, normals, Threads{1});
    mesh.points += missing / geometry::area(mesh.points, mesh.triangles) * normals.cast<double>();
  }
}

/// One label's way from voxels to a surface.
LabelSurface surfaceOf(const LabelMap& map, std::size_t segment, const LabelSurfaceOptions& options,
                       const Progress& progress) {
  VoxelBox box = voxelsOf(map, segment);
  const VoxelPieces pieces = voxelPieces(box, options.largestPieceOnly);
  LabelSurface surface;
  surface.segment = segment;
  surface.pieces = options.largestPieceOnly ? 1 : pieces.count;
  surface.voxelVolumeMm3 = static_cast<double>(box.count) * map.voxelVolumeMm3();
  if (pieces.count > 1) {
    const std::string size =
        counted(static_cast<std::uint64_t>(map.segments[segment].voxels - pieces.largest), "voxel", "voxels");
    surface.warnings.push_back(
        counted(static_cast<std::uint64_t>(pieces.count), "piece", "pieces") + ", " + size +
        (options.largestPieceOnly ? " besides the largest left out" : " besides the largest"));
  }
  progress.throwIfCancelled();
  const TriangleMesh contour = contourOf(box, map);
  for (const double part : kTries) {
    progress.throwIfCancelled();
    surface.mesh = thinned(smoothed(contour, part * options.smoothing), options.triangles);
    correctVolume(surface.mesh, surface.voxelVolumeMm3);
    surface.volumeMm3 = geometry::volume(surface.mesh.points, surface.mesh.triangles, Threads{1});
    const double error = std::abs(surface.volumeMm3 - surface.voxelVolumeMm3);
    if (isSound(surface.mesh) && error <= kVolumeTolerance * surface.voxelVolumeMm3)
      return surface;
  }
  surface.warnings.push_back("is too thin in places for a surface with the volume of its voxels");
  return surface;
}

std::vector<std::size_t> requestedSegments(const LabelMap& map, const LabelSurfaceOptions& options) {
  std::vector<std::size_t> list = options.segments;
  if (list.empty()) {
    list.resize(map.segments.size());
    std::iota(list.begin(), list.end(), std::size_t{0});
  }
  for (const std::size_t segment : list)
    if (segment >= map.segments.size())
      throw UsageError("the label map has no segment number " + std::to_string(segment), {},
                       "it has " + counted(map.segments.size(), "segment", "segments"));
  return list;
}

} // namespace

std::vector<LabelSurface> labelSurfaces(const LabelMap& map, const LabelSurfaceOptions& options,
                                        Progress& progress, Threads threads) {
  const std::vector<std::size_t> segments = requestedSegments(map, options);
  // The large ones first: the last thread to finish should not have just begun with one.
  std::vector<std::size_t> order(segments.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return map.segments[segments[a]].voxels > map.segments[segments[b]].voxels;
  });
  std::vector<LabelSurface> surfaces(segments.size());
  std::atomic<int> done{0};
  progress.report(0, "surfaces");
  parallelRanges(static_cast<Eigen::Index>(order.size()), 1, threads, [&](Eigen::Index begin, Eigen::Index) {
    const std::size_t place = order[static_cast<std::size_t>(begin)];
    surfaces[place] = surfaceOf(map, segments[place], options, progress);
    progress.report(static_cast<double>(++done) / static_cast<double>(order.size()),
                    map.segments[segments[place]].name);
  });
  return surfaces;
}

} // namespace viscera::medical_io
