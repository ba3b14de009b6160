#include "viscera/geometry/coarse_triangles.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "viscera/core/disjoint_sets.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/volume.h"

namespace viscera::geometry {
namespace {

/// A surface of area A meets about this many times A / h^2 cubes of edge h.
constexpr double kCubesMet = 1.5;
constexpr int kBitsOfAxis = 20;

/// The cube that each vertex lies in.
std::vector<std::uint64_t> cubesOf(const Points& points, double edge) {
  const Vec3 low = points.colwise().minCoeff();
  std::vector<std::uint64_t> cubes(static_cast<std::size_t>(points.rows()), 0);
  for (Eigen::Index v = 0; v < points.rows(); ++v)
    for (int axis = 0; axis < 3; ++axis) {
      const double at = std::min((points(v, axis) - low[axis]) / edge, double((1 << kBitsOfAxis) - 1));
      std::uint64_t& cube = cubes[static_cast<std::size_t>(v)];
      cube = (cube << kBitsOfAxis) | static_cast<std::uint64_t>(at);
    }
  return cubes;
}

/// The set of vertices in its cube that edges within the cube connect with each vertex, named by its
/// first vertex. The two sides of a thin muscle stay two sets but at its rim, where edges connect them.
std::vector<std::int32_t> clustersOf(const TriangleMesh& mesh, double edge) {
  const std::vector<std::uint64_t> cubes = cubesOf(mesh.points, edge);
  DisjointSets joined(cubes.size());
  for (const auto& triangle : mesh.triangles.rowwise())
    for (int corner = 0; corner < 3; ++corner) {
      const auto from = static_cast<std::size_t>(triangle[corner]);
      const auto to = static_cast<std::size_t>(triangle[(corner + 1) % 3]);
      if (cubes[from] == cubes[to])
        joined.join(from, to);
    }
  std::vector<std::int32_t> clusters(cubes.size());
  for (std::size_t v = 0; v < clusters.size(); ++v)
    clusters[v] = static_cast<std::int32_t>(joined.root(v));
  return clusters;
}

/// The vertex of its cluster that is nearest to the mean of the cluster, for each vertex.
std::vector<std::int32_t> representatives(const TriangleMesh& mesh, double edge) {
  const std::vector<std::int32_t> clusters = clustersOf(mesh, edge);
  Points means = Points::Zero(mesh.points.rows(), 3);
  Eigen::VectorXd sizes = Eigen::VectorXd::Zero(mesh.points.rows());
  for (std::size_t v = 0; v < clusters.size(); ++v) {
    means.row(clusters[v]) += mesh.points.row(static_cast<Eigen::Index>(v));
    ++sizes[clusters[v]];
  }
  std::vector<std::int32_t> nearest(clusters.size());
  Eigen::VectorXd least =
      Eigen::VectorXd::Constant(mesh.points.rows(), std::numeric_limits<double>::infinity());
  for (std::size_t v = 0; v < clusters.size(); ++v) {
    const std::int32_t cluster = clusters[v];
    const auto point = mesh.points.row(static_cast<Eigen::Index>(v));
    const double away = (point - means.row(cluster) / sizes[cluster]).squaredNorm();
    if (away < least[cluster]) {
      least[cluster] = away;
      nearest[static_cast<std::size_t>(cluster)] = static_cast<std::int32_t>(v);
    }
  }
  std::vector<std::int32_t> chosen(clusters.size());
  for (std::size_t v = 0; v < clusters.size(); ++v)
    chosen[v] = nearest[static_cast<std::size_t>(clusters[v])];
  return chosen;
}

} // namespace

Triangles coarseTriangles(const TriangleMesh& mesh, Eigen::Index vertices) {
  if (vertices < 4)
    throw UsageError(misuse("a coarse surface needs at least four vertices"));
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
