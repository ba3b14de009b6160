#include "viscera/tracking/surface_distance.h"

#include <utility>

namespace viscera::tracking {
namespace {

/// So near to the surface the way to its nearest point says nothing.
constexpr double kOnSurfaceMm = 1e-9;
/// Tree, normals and corners together, a triangle.
constexpr std::size_t kBytesOfTriangle = 400;

} // namespace

MeshDistance::MeshDistance(std::shared_ptr<const geometry::TriangleMesh> mesh)
    : mesh_(std::move(mesh)), distance_(mesh_) {}

double MeshDistance::at(const Vec3& point, Vec3& direction) const {
  const double distance = distance_(point);
  // grad d = sign(d) (p - c) / |p - c|, c the nearest point of the surface.
  const Vec3 away = point - distance_.nearest(point);
  const double length = away.norm();
  direction = length > kOnSurfaceMm ? Vec3((distance < 0 ? -away : away) / length) : Vec3(Vec3::Zero());
  return distance;
}

std::size_t MeshDistance::bytes() const {
  return kBytesOfTriangle * static_cast<std::size_t>(mesh_->triangles.rows());
}

} // namespace viscera::tracking
