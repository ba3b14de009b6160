#include "viscera/geometry/coarse_triangles.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "viscera/core/error.h"
#include "viscera/geometry/normals.h"
#include "viscera/geometry/volume.h"

namespace viscera::geometry {
namespace {

/// A surface of area A meets about this many times A / h^2 cubes of edge h, each for one octant of normals.
constexpr double kCubesMet = 1.8;
constexpr int kBitsOfAxis = 20;

/// The cube of each vertex with the octant of its normal, and the vertex, by cubes. Without the octants the
/// two sides of a thin muscle would become one.
std::vector<std::pair<std::uint64_t, std::int32_t>> byCube(const TriangleMesh& mesh, double edge) {
  const Points& points = mesh.points;
  const Normals normals = vertexNormals(mesh);
  const Vec3 low = points.colwise().minCoeff();
  std::vector<std::pair<std::uint64_t, std::int32_t>> cubes(static_cast<std::size_t>(points.rows()));
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis)
      key = (key << 1) | std::uint64_t(normals(v, axis) < 0);
    for (int axis = 0; axis < 3; ++axis) {
      const double at = std::min((points(v, axis) - low[axis]) / edge, double((1 << kBitsOfAxis) - 1));
      key = (key << kBitsOfAxis) | static_cast<std::uint64_t>(at);
    }
    cubes[static_cast<std::size_t>(v)] = {key, static_cast<std::int32_t>(v)};
  }
  std::sort(cubes.begin(), cubes.end());
  return cubes;
}

/// For each vertex the one that stands for its cube.
std::vector<std::int32_t> representatives(const TriangleMesh& mesh, double edge) {
  const Points& points = mesh.points;
  const auto cubes = byCube(mesh, edge);
  std::vector<std::int32_t> chosen(cubes.size());
  for (std::size_t begin = 0; begin < cubes.size();) {
    std::size_t end = begin;
    Vec3 mean = Vec3::Zero();
    for (; end < cubes.size() && cubes[end].first == cubes[begin].first; ++end)
      mean += points.row(cubes[end].second).transpose();
    mean /= static_cast<double>(end - begin);
    std::int32_t best = cubes[begin].second;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = begin; i < end; ++i) {
      const double away = (points.row(cubes[i].second).transpose() - mean).squaredNorm();
      if (away < least) {
        least = away;
        best = cubes[i].second;
      }
    }
    for (; begin < end; ++begin)
      chosen[static_cast<std::size_t>(cubes[begin].second)] = best;
  }
  return chosen;
}

} // namespace

Triangles coarseTriangles(const TriangleMesh& mesh, Eigen::Index vertices) {
  if (vertices < 4)
    throw UsageError("a coarse surface needs at least four vertices");
  const double edge = std::sqrt(kCubesMet * area(mesh.points, mesh.triangles) / double(vertices));
  if (mesh.points.rows() <= vertices || !(edge > 0) || !std::isfinite(edge))
    return mesh.triangles;
  const std::vector<std::int32_t> chosen = representatives(mesh, edge);
  Triangles coarse(mesh.triangles.rows(), 3);
  Eigen::Index count = 0;
  for (const auto& triangle : mesh.triangles.rowwise()) {
    const std::int32_t a = chosen[static_cast<std::size_t>(triangle[0])];
    const std::int32_t b = chosen[static_cast<std::size_t>(triangle[1])];
    const std::int32_t c = chosen[static_cast<std::size_t>(triangle[2])];
    if (a != b && b != c && c != a)
      coarse.row(count++) << a, b, c;
  }
  coarse.conservativeResize(count, 3);
  return coarse;
}

} // namespace viscera::geometry
