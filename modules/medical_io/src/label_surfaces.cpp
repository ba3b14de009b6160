#include "viscera/medical_io/label_surfaces.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <numeric>

#include "file_bytes.h"
#include "label_smoothing.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/decimate_surface.h"
#include "viscera/geometry/normals.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/geometry/volume.h"
#include "viscera/medical_io/contour.h"
#include "viscera/medical_io/plausible_size.h"
#include "voxel_pieces.h"

namespace viscera::medical_io {
namespace {

using geometry::TriangleMesh;

/// A label that smoothing spoils is tried again with these parts of it.
constexpr std::array<double, 4> kTries = {1, 0.5, 0.25, 0};
/// The volume is corrected until it is this close, relative to the voxels'.
constexpr double kCorrectedWithin = 1e-4;
constexpr int kMostCorrections = 20;
/// Steps are at most this part of a voxel, and no more than a voxel's diagonal in all: what smoothing
/// has shrunk to almost nothing would else be blown up to shards that reach across the image.
constexpr double kMostStep = 0.25;

/// The steps between the voxels, in mm LPS, outward.
TriangleMesh stepsBetween(const VoxelBox& box, const LabelMap& map) {
  TriangleMesh mesh = contourOf(box.inside, box.size, 0.5);
  const Vec3 low(box.low[0], box.low[1], box.low[2]);
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v)
    mesh.points.row(v) = (map.indexToLps * (mesh.points.row(v).transpose() + low)).transpose();
  // A left-handed grid turns the triangles around.
  geometry::orientOutward(mesh);
  return mesh;
}

bool isSound(const geometry::SurfaceReport& report) {
  return report.closed() && report.manifold() && report.volumeMm3 > 0;
}

/// Moves all vertices along their normals until the surface encloses `target` mm^3, or they are too far from
/// the voxels, whose axes are the columns of `voxel`.
void correctVolume(TriangleMesh& mesh, double target, const Eigen::Matrix3d& voxel) {
  const double mostStep = kMostStep * std::cbrt(std::abs(voxel.determinant()));
  const double mostReach = voxel.colwise().norm().norm();
  double reach = 0;
  const geometry::VertexTriangles around = geometry::vertexTriangles(mesh.points.rows(), mesh.triangles);
  geometry::Normals normals;
  for (int i = 0; i < kMostCorrections; ++i) {
    const double missing = target - geometry::volume(mesh.points, mesh.triangles, Threads{1});
    if (std::abs(missing) <= kCorrectedWithin * target)
      return;
    // Moved by h along its normals a surface gains A h to first order: Newton's step is missing / A.
    const double step =
        std::clamp(missing / geometry::area(mesh.points, mesh.triangles), -mostStep, mostStep);
    reach += step;
    if (!(std::abs(reach) <= mostReach))
      return;
    geometry::vertexNormals(mesh.points, mesh.triangles, around, normals, Threads{1});
    mesh.points += step * normals.cast<double>();
  }
}

/// Warnings about a label before its surface is made.
std::vector<Text> warningsOf(const LabelMap& map, std::size_t index, const VoxelPieces& pieces,
                             const std::optional<ImageCut>& cut, bool largestOnly) {
  const Segment& segment = map.segments[index];
  std::vector<Text> warnings;
  if (pieces.count > 1)
    warnings.push_back(largestOnly ? phrase("%2 pieces, %n {voxel|voxels} besides the largest left out",
                                            segment.voxels - pieces.largest, pieces.count)
                                   : phrase("%2 pieces, %n {voxel|voxels} besides the largest",
                                            segment.voxels - pieces.largest, pieces.count));
  if (cut)
    warnings.push_back(cut->text());
  if (auto warning = doubtAboutVolume(segment.name, map.volumeMl(segment)))
    warnings.push_back(std::move(*warning));
  return warnings;
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
  surface.cut = imageCut(map, segment);
  surface.warnings = warningsOf(map, segment, pieces, surface.cut, options.largestPieceOnly);
  progress.throwIfCancelled();
  const TriangleMesh steps = stepsBetween(box, map);
  for (const double part : kTries) {
    progress.throwIfCancelled();
    surface.mesh = smoothSteps(steps, map.indexToLps.linear(), part * options.smoothing);
    if (options.triangles > 0)
      surface.mesh = geometry::decimateClosedSurface(surface.mesh, options.triangles, progress);
    correctVolume(surface.mesh, surface.voxelVolumeMm3, map.indexToLps.linear());
    surface.volumeMm3 = geometry::volume(surface.mesh.points, surface.mesh.triangles, Threads{1});
    const double error = std::abs(surface.volumeMm3 - surface.voxelVolumeMm3);
    surface.report = geometry::checkSurface(surface.mesh);
    if (isSound(surface.report) && error <= kVolumeTolerance * surface.voxelVolumeMm3)
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
      throw UsageError(misuse("the label map has no segment number %1", segment), {},
                       misuse("it has %n {segment|segments}", map.segments.size()));
  return list;
}

} // namespace

std::vector<LabelSurface> labelSurfaces(const LabelMap& map, const LabelSurfaceOptions& options,
                                        Progress& progress, Threads threads, const SurfaceListener& made) {
  const std::vector<std::size_t> segments = requestedSegments(map, options);
  // The large ones first: the last thread to finish should not have just begun with one.
  std::vector<std::size_t> order(segments.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return map.segments[segments[a]].voxels > map.segments[segments[b]].voxels;
  });
  std::vector<LabelSurface> surfaces(segments.size());
  std::atomic<int> done{0};
  std::mutex telling;
  progress.report(0, "surfaces");
  parallelRanges(static_cast<Eigen::Index>(order.size()), 1, threads, [&](Eigen::Index begin, Eigen::Index) {
    const std::size_t place = order[static_cast<std::size_t>(begin)];
    surfaces[place] = surfaceOf(map, segments[place], options, progress);
    if (made) {
      const std::lock_guard lock(telling);
      made(surfaces[place]);
    }
    progress.report(static_cast<double>(++done) / static_cast<double>(order.size()),
                    named(map.segments[segments[place]].name));
  });
  return surfaces;
}

} // namespace viscera::medical_io
