#include "sequence_binding.h"

#include <numeric>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "viscera/coordinates/systems.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/geometry/volume.h"
#include "viscera/sequences/breathing.h"

namespace viscera::live {
namespace {

/// Weights fall with about this power of the distance, so that a handle moves what is near it.
constexpr double kLocality = 6;

constexpr int kLiverHandles = 38;
constexpr int kBoxCorners = 8;

/// A pose of a cavity takes less time than waking other threads, and calibration asks for hundreds.
constexpr Threads kOneThread{1};

std::shared_ptr<const coordinates::CoordinateSystem> systemOf(const document::SystemChoice& choice) {
  for (const auto& system : coordinates::builtInSystems())
    if (system->id() == choice.id)
      return system;
  throw UsageError(phrase("there is no coordinate system \"%1\"", choice.id), "sequence");
}

} // namespace

document::SystemChoice softCoordinates(double softnessMm) {
  document::SystemChoice choice;
  choice.parameters.set("locality", kLocality);
  choice.parameters.set("softness", softnessMm);
  return choice;
}

MovedVolume::MovedVolume(std::shared_ptr<const geometry::TriangleMesh> mesh, const Points& restHandles,
                         const document::SystemChoice& system, Threads threads)
    : mesh_(std::move(mesh)) {
  coordinates::HandleSet handles;
  handles.positions = restHandles;
  Progress progress;
  binding_ = systemOf(system)->bind(handles, mesh_->points, {system.parameters, threads}, progress);
  if (!binding_->report().failures.empty())
    throw DataError(phrase("%n {vertex lies|vertices lie} outside the hull of the sequence's handles",
                           binding_->report().failures.size()),
                    "sequence");
}

geometry::TriangleMesh MovedVolume::surfaceAt(const Points& pose) const {
  geometry::TriangleMesh surface;
  binding_->deform(pose, surface.points, kOneThread);
  surface.triangles = mesh_->triangles;
  return surface;
}

double MovedVolume::at(const Points& pose) const {
  Points points;
  binding_->deform(pose, points, kOneThread);
  return geometry::volume(points, mesh_->triangles, kOneThread) / kMm3PerMl;
}

std::array<double, 4> MovedVolume::along(const Points& pose, const Points& direction) const {
  Points from;
  Points change;
  binding_->deform(pose, from, kOneThread);
  binding_->deform(pose + direction, change, kOneThread);
  change -= from;
  const Vec3 origin = from.row(0);
  std::array<double, 4> sum{};
  for (Eigen::Index t = 0; t < mesh_->triangles.rows(); ++t) {
    const auto corner = mesh_->triangles.row(t);
    const Vec3 p = from.row(corner[0]).transpose() - origin;
    const Vec3 q = from.row(corner[1]).transpose() - origin;
    const Vec3 r = from.row(corner[2]).transpose() - origin;
    const Vec3 u = change.row(corner[0]);
    const Vec3 v = change.row(corner[1]);
    const Vec3 w = change.row(corner[2]);
    // (p + x u) . ((q + x v) x (r + x w)), sorted by powers of x.
    const Vec3 none = q.cross(r);
    const Vec3 once = q.cross(w) + v.cross(r);
    const Vec3 twice = v.cross(w);
    sum[0] += p.dot(none);
    sum[1] += p.dot(once) + u.dot(none);
    sum[2] += p.dot(twice) + u.dot(once);
    sum[3] += u.dot(twice);
  }
  for (double& coefficient : sum)
    coefficient /= 6 * kMm3PerMl;
  return sum;
}

sequences::VolumeAlong volumeAlong(std::shared_ptr<const MovedVolume> volume) {
  return [volume = std::move(volume)](const Points& pose, const Points& direction) {
    return volume->along(pose, direction);
  };
}

std::shared_ptr<const sequences::Sequence> liverBreathing(const geometry::TriangleMesh& surface) {
  deformation::Placement placement;
  placement.count = kLiverHandles;
  const Points handles = deformation::placeHandles(surface, placement);
  std::vector<int> rows(static_cast<std::size_t>(handles.rows()));
  std::iota(rows.begin(), rows.end(), 0);
  // The corners come first.
  std::vector<sequences::HandleGroup> groups{
      {"Far corners", {0.60, 0.60, 0.60}, {rows.begin(), rows.begin() + kBoxCorners}},
      {"Liver", {0.90, 0.62, 0.00}, {rows.begin() + kBoxCorners, rows.end()}}};
  return std::make_shared<sequences::LiverBreathing>(handles, boundsOf(surface.points), std::move(groups));
}

sequences::PoseCompensation compensationFor(const Points& restHandles, const document::SystemChoice& system,
                                            Threads threads) {
  coordinates::HandleSet handles;
  handles.positions = restHandles;
  Progress progress;
  const auto binding = systemOf(system)->bind(handles, restHandles, {system.parameters, threads}, progress);
  const Eigen::Index n = restHandles.rows();
  Eigen::MatrixXd weights(n, n);
  for (Eigen::Index handle = 0; handle < n; ++handle)
    weights.col(handle) = binding->influence(static_cast<int>(handle));
  for (const int row : binding->report().failures)
    weights.row(row) = Eigen::RowVectorXd::Unit(n, row);
  return sequences::PoseCompensation(weights);
}

std::shared_ptr<const geometry::TriangleMesh> surfaceOf(const sample_organs::SampleOrgan& organ,
                                                        const std::string& name) {
  for (const sample_organs::SampleSurface& surface : organ.surfaces)
    if (surface.name == name)
      return surface.mesh;
  throw DataError(misuse("the sample organ has no surface \"%1\"", name), organ.name,
                  misuse("restore its definition from the installation"));
}

} // namespace viscera::live
