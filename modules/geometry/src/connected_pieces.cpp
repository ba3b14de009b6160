#include "viscera/geometry/connected_pieces.h"

#include <cstdint>
#include <numeric>

namespace viscera::geometry {
namespace {

/// Disjoint sets of vertices with path halving.
class DisjointSets {
public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::int32_t(0));
  }
  std::int32_t root(std::int32_t i) {
    while (parent_[std::size_t(i)] != i) {
      parent_[std::size_t(i)] = parent_[std::size_t(parent_[std::size_t(i)])];
      i = parent_[std::size_t(i)];
    }
    return i;
  }
  void join(std::int32_t a, std::int32_t b) { parent_[std::size_t(root(a))] = root(b); }

private:
  std::vector<std::int32_t> parent_;
};

} // namespace

ConnectedPieces connectedPieces(const TriangleMesh& mesh) {
  const auto vertices = static_cast<std::size_t>(mesh.points.rows());
  DisjointSets sets(vertices);
  std::vector<bool> used(vertices, false);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    sets.join(mesh.triangles(t, 0), mesh.triangles(t, 1));
    sets.join(mesh.triangles(t, 1), mesh.triangles(t, 2));
    for (int k = 0; k < 3; ++k)
      used[static_cast<std::size_t>(mesh.triangles(t, k))] = true;
  }
  ConnectedPieces pieces;
  pieces.ofVertex.assign(vertices, -1);
  std::vector<int> ofRoot(vertices, -1);
  for (std::size_t v = 0; v < vertices; ++v) {
    if (!used[v])
      continue;
    int& piece = ofRoot[static_cast<std::size_t>(sets.root(static_cast<std::int32_t>(v)))];
    if (piece < 0)
      piece = pieces.count++;
    pieces.ofVertex[v] = piece;
  }
  return pieces;
}

} // namespace viscera::geometry
