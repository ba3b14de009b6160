#include "viscera/geometry/connected_pieces.h"

#include <algorithm>
#include <cstdint>

#include "viscera/core/disjoint_sets.h"
#include "viscera/geometry/volume.h"

namespace viscera::geometry {
namespace {

std::size_t pieceOf(const ConnectedPieces& pieces, const TriangleMesh& mesh, Eigen::Index triangle) {
  return static_cast<std::size_t>(pieces.ofVertex[static_cast<std::size_t>(mesh.triangles(triangle, 0))]);
}

} // namespace

ConnectedPieces connectedPieces(const TriangleMesh& mesh) {
  const auto vertices = static_cast<std::size_t>(mesh.points.rows());
  DisjointSets sets(vertices);
  std::vector<bool> used(vertices, false);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto first = static_cast<std::size_t>(mesh.triangles(t, 0));
    for (int k = 0; k < 3; ++k) {
      const auto corner = static_cast<std::size_t>(mesh.triangles(t, k));
      sets.join(first, corner);
      used[corner] = true;
    }
  }
  ConnectedPieces pieces;
  pieces.ofVertex.assign(vertices, -1);
  std::vector<int> ofRoot(vertices, -1);
  for (std::size_t v = 0; v < vertices; ++v) {
    if (!used[v])
      continue;
    int& piece = ofRoot[sets.root(v)];
    if (piece < 0)
      piece = pieces.count++;
    pieces.ofVertex[v] = piece;
  }
  return pieces;
}

std::vector<double> areasOf(const ConnectedPieces& pieces, const TriangleMesh& mesh) {
  std::vector<double> areas(static_cast<std::size_t>(pieces.count), 0.0);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    areas[pieceOf(pieces, mesh, t)] += areaOf(mesh.points, mesh.triangles, t);
  return areas;
}

TriangleMesh largestPiece(const TriangleMesh& mesh) {
  const ConnectedPieces pieces = connectedPieces(mesh);
  if (pieces.count == 0)
    return mesh;
  const std::vector<double> areas = areasOf(pieces, mesh);
  const auto largest = std::max_element(areas.begin(), areas.end()) - areas.begin();
  std::vector<Eigen::Index> vertices, triangles;
  std::vector<std::int32_t> names(pieces.ofVertex.size(), -1);
  for (std::size_t v = 0; v < names.size(); ++v)
    if (pieces.ofVertex[v] == largest) {
      names[v] = static_cast<std::int32_t>(vertices.size());
      vertices.push_back(static_cast<Eigen::Index>(v));
    }
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    if (names[static_cast<std::size_t>(mesh.triangles(t, 0))] >= 0)
      triangles.push_back(t);
  TriangleMesh piece;
  piece.points = mesh.points(vertices, Eigen::all);
  piece.triangles = mesh.triangles(triangles, Eigen::all).unaryExpr([&](std::int32_t v) {
    return names[static_cast<std::size_t>(v)];
  });
  if (mesh.colors.rows() > 0)
    piece.colors = mesh.colors(vertices, Eigen::all);
  return piece;
}

} // namespace viscera::geometry
