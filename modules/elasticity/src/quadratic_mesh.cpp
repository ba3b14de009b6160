#include "viscera/elasticity/quadratic_mesh.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace viscera::elasticity {
namespace {

/// The local number of the node in the middle of an edge.
int middleOf(int a, int b) {
  for (int e = 0; e < 6; ++e)
    if ((kEdges[std::size_t(e)][0] == a && kEdges[std::size_t(e)][1] == b) ||
        (kEdges[std::size_t(e)][0] == b && kEdges[std::size_t(e)][1] == a))
      return 4 + e;
  return -1;
}

} // namespace

QuadraticMesh quadraticMesh(const Points& points, const deformation::Tetrahedra& tetrahedra) {
  struct Use {
    std::int32_t low, high;
    Eigen::Index tetrahedron;
    int edge;
  };
  std::vector<Use> uses;
  uses.reserve(static_cast<std::size_t>(6 * tetrahedra.rows()));
  for (Eigen::Index t = 0; t < tetrahedra.rows(); ++t)
    for (int e = 0; e < 6; ++e) {
      const auto& [from, to] = kEdges[std::size_t(e)];
      const auto [low, high] = std::minmax(tetrahedra(t, from), tetrahedra(t, to));
      uses.push_back({low, high, t, e});
    }
  std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) {
    return std::tie(a.low, a.high, a.tetrahedron, a.edge) < std::tie(b.low, b.high, b.tetrahedron, b.edge);
  });
  QuadraticMesh mesh;
  mesh.corners = points.rows();
  mesh.tetrahedra.resize(tetrahedra.rows(), 10);
  mesh.tetrahedra.leftCols<4>() = tetrahedra;
  std::vector<Vec3> middles;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const Use& use = uses[i];
    if (i == 0 || use.low != uses[i - 1].low || use.high != uses[i - 1].high)
      middles.push_back(0.5 * (points.row(use.low) + points.row(use.high)).transpose());
    mesh.tetrahedra(use.tetrahedron, 4 + use.edge) =
        static_cast<std::int32_t>(points.rows() + static_cast<Eigen::Index>(middles.size()) - 1);
  }
  mesh.nodes.resize(points.rows() + static_cast<Eigen::Index>(middles.size()), 3);
  mesh.nodes << points, pointsOf(middles);
  return mesh;
}

std::array<int, 6> nodesOfFace(int opposite) {
  // Outward for a tetrahedron with (b - a) x (c - a) . (d - a) > 0.
  static constexpr int corners[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  const auto& c = corners[opposite];
  return {c[0], c[1], c[2], middleOf(c[0], c[1]), middleOf(c[1], c[2]), middleOf(c[2], c[0])};
}

std::vector<Face> boundaryFaces(const QuadraticMesh& mesh) {
  std::vector<std::pair<std::array<std::int32_t, 3>, Face>> all;
  for (Eigen::Index t = 0; t < mesh.tetrahedra.rows(); ++t)
    for (int opposite = 0; opposite < 4; ++opposite) {
      const auto nodes = nodesOfFace(opposite);
      std::array<std::int32_t, 3> key;
      for (std::size_t k = 0; k < 3; ++k)
        key[k] = mesh.tetrahedra(t, nodes[k]);
      std::sort(key.begin(), key.end());
      all.push_back({key, {static_cast<std::int32_t>(t), opposite}});
    }
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Face> faces;
  for (std::size_t i = 0; i < all.size(); ++i)
    if ((i == 0 || all[i - 1].first != all[i].first) &&
        (i + 1 == all.size() || all[i + 1].first != all[i].first))
      faces.push_back(all[i].second);
  std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) {
    return std::tie(a.tetrahedron, a.opposite) < std::tie(b.tetrahedron, b.opposite);
  });
  return faces;
}

} // namespace viscera::elasticity
