#include "surface/polygonise.h"

#include <algorithm>
#include <vector>

#include "surface/sample_grid.h"
#include "viscera/contour/contour.h"
#include "viscera/core/error.h"
#include "viscera/geometry/connected_pieces.h"
#include "viscera/geometry/surface_check.h"

namespace viscera::sample_organs {
namespace {

using geometry::TriangleMesh;

/// The piece with the most triangles, points in the order in which triangles name them.
TriangleMesh largestPart(const TriangleMesh& mesh) {
  const auto [count, piece] = geometry::connectedPieces(mesh);
  std::vector<int> size(static_cast<std::size_t>(count), 0);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    ++size[static_cast<std::size_t>(piece[static_cast<std::size_t>(mesh.triangles(t, 0))])];
  const auto largest = static_cast<std::int32_t>(std::max_element(size.begin(), size.end()) - size.begin());

  TriangleMesh result;
  std::vector<std::int32_t> renamed(piece.size(), -1);
  std::int32_t points = 0;
  Eigen::Index triangles = 0;
  result.points.resize(mesh.points.rows(), 3);
  result.triangles.resize(mesh.triangles.rows(), 3);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    if (piece[static_cast<std::size_t>(mesh.triangles(t, 0))] != largest)
      continue;
    for (int k = 0; k < 3; ++k) {
      std::int32_t& name = renamed[static_cast<std::size_t>(mesh.triangles(t, k))];
      if (name < 0) {
        name = points++;
        result.points.row(name) = mesh.points.row(mesh.triangles(t, k));
      }
      result.triangles(triangles, k) = name;
    }
    ++triangles;
  }
  result.points.conservativeResize(points, 3);
  result.triangles.conservativeResize(triangles, 3);
  return result;
}

} // namespace

TriangleMesh polygonise(const ImplicitNode& node, double spacing, Threads threads,
                        const ProgressSpan& progress) {
  const SampleGrid grid = sampleGrid(node, spacing, threads, progress);
  const TriangleMesh all = contour::contourOf(grid.values, grid.size, 0, grid.origin, grid.spacing);
  if (all.triangles.rows() == 0)
    throw DataError("the implicit surface is empty", {},
                    "check that its parts meet and that \"spacing\" is fine enough");
  TriangleMesh mesh = largestPart(all);
  geometry::orientOutward(mesh);
  return mesh;
}

} // namespace viscera::sample_organs
