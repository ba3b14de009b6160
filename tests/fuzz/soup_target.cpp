#include <cmath>
#include <memory>

#include "fuzz_target.h"
#include "viscera/coordinates/systems.h"
#include "viscera/core/error.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/deformation/deformer.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/deformation/volume_lock.h"
#include "viscera/geometry/clean_surface.h"
#include "viscera/geometry/close_holes.h"
#include "viscera/geometry/self_intersections.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/geometry/volume.h"

/// Any triangles through check, repair, volume, handles, bind, pose and lock.
namespace viscera::fuzz {
namespace {

/// Enough for every way in which triangles can lie to each other; pairs of them are compared exactly.
constexpr std::size_t kMostPoints = 24, kMostTriangles = 40;
constexpr std::size_t kBytesOfPoint = 6, kBytesOfTriangle = 3;

double coordinate(Bytes bytes, std::size_t at) {
  const int steps = static_cast<std::int16_t>(bytes[at] | bytes[at + 1] << 8);
  return steps / 16.0;
}

/// First the number of points, then their coordinates in sixteenths of a mm, then triangles.
geometry::TriangleMesh soup(Bytes bytes) {
  geometry::TriangleMesh mesh;
  if (bytes.empty())
    return mesh;
  std::size_t points = bytes.front() % (kMostPoints + 1);
  bytes = bytes.subspan(1);
  points = std::min(points, bytes.size() / kBytesOfPoint);
  mesh.points.resize(static_cast<Eigen::Index>(points), 3);
  for (std::size_t p = 0; p < points; ++p)
    for (std::size_t c = 0; c < 3; ++c)
      mesh.points(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(c)) =
          coordinate(bytes, kBytesOfPoint * p + 2 * c);
  bytes = bytes.subspan(kBytesOfPoint * points);
  const std::size_t triangles = points == 0 ? 0 : std::min(kMostTriangles, bytes.size() / kBytesOfTriangle);
  mesh.triangles.resize(static_cast<Eigen::Index>(triangles), 3);
  for (std::size_t t = 0; t < triangles; ++t)
    for (std::size_t c = 0; c < 3; ++c)
      mesh.triangles(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(c)) =
          static_cast<std::int32_t>(bytes[kBytesOfTriangle * t + c] % points);
  return mesh;
}

void checkRepairs(const geometry::TriangleMesh& mesh) {
  Progress progress;
  geometry::checkSurface(mesh);
  geometry::countSelfIntersections(mesh, progress, {1});
  const geometry::CleanedSurface cleaned = geometry::cleanSurface(mesh);
  geometry::requireValid(cleaned.mesh, "the cleaned surface");
  const geometry::ClosedSurface closed = geometry::closeHoles(cleaned.mesh);
  geometry::requireValid(closed.mesh, "the closed surface");
  require(closed.mesh.points.topRows(cleaned.mesh.points.rows()) == cleaned.mesh.points,
          "Closing holes moves nothing.");
}

/// Also around a soup that no handles can be placed on.
Points handlesAround(const geometry::TriangleMesh& mesh) {
  try {
    return deformation::placeHandles(mesh, {12, true, 0.05, 0.15});
  } catch (const Error&) {
    return deformation::enclosingHandles(mesh.points);
  }
}

void deform(const std::shared_ptr<const geometry::TriangleMesh>& mesh) {
  Progress progress;
  coordinates::HandleSet handles;
  handles.positions = handlesAround(*mesh);
  require(handles.positions.allFinite(), "Handles have places.");
  const auto binding =
      deformation::bindOrgan(*coordinates::sCelestial(), handles, mesh->points, {{}, {1}}, progress);
  deformation::Deformer deformer(mesh, binding, handles.positions, {1});
  const double size = (mesh->points.colwise().maxCoeff() - mesh->points.colwise().minCoeff()).norm();
  require((deformer.points() - mesh->points).cwiseAbs().maxCoeff() <= 1e-6 * (1 + size),
          "At rest nothing moves.");
  deformer.moveHandle(0, handles.positions.row(0).transpose() + Vec3(0.05 * size, 0, 0));
  require(deformer.points().allFinite(), "A pose has places.");
  const double target = deformer.restVolumeMm3();
  if (!geometry::checkSurface(*mesh).outward() || target < 1e-3 * size * size * size)
    return;
  const deformation::VolumeLock lock({{"organ", mesh, binding, target}}, {1});
  const deformation::RestoredPose kept =
      lock.restore(deformer.pose(), deformation::restingHandles(handles.positions, deformer.pose()),
                   deformation::LeastDisplacement(), size);
  require(kept.restored || !kept.reason.empty(), "A lock that fails says why.");
  require(!kept.restored || std::abs(lock.volumes(kept.pose)[0] / target - 1) < 1e-9,
          "A lock keeps the volume.");
}

void useSoup(Bytes bytes) {
  const auto mesh = std::make_shared<const geometry::TriangleMesh>(soup(bytes));
  geometry::requireValid(*mesh, "the soup");
  checkRepairs(*mesh);
  deform(mesh);
}

std::string soupOf(const std::vector<std::array<int, 3>>& points,
                   const std::vector<std::array<int, 3>>& triangles) {
  std::string out(1, static_cast<char>(points.size()));
  for (const auto& point : points)
    for (const int millimetres : point) {
      const auto steps = static_cast<std::uint16_t>(16 * millimetres);
      out += {static_cast<char>(steps & 255), static_cast<char>(steps >> 8)};
    }
  for (const auto& triangle : triangles)
    for (const int corner : triangle)
      out += static_cast<char>(corner);
  return out;
}

std::vector<std::string> soupSeeds() {
  const std::vector<std::array<int, 3>> corners = {{0, 0, 0}, {100, 0, 0}, {0, 100, 0}, {0, 0, 100}};
  return {soupOf(corners, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}), // A tetrahedron,
          soupOf(corners, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}}),            // an open one,
          soupOf({{0, 0, 0}, {90, 0, 0}, {90, 90, 0}, {0, 90, 0}},
                 {{0, 1, 2}, {0, 2, 3}, {1, 3, 2}})}; // a flat one.
}

} // namespace

Target surfaceSoupTarget() {
  return {"surface_soups", useSoup, soupSeeds};
}

} // namespace viscera::fuzz
