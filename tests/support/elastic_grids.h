#pragma once

#include <array>
#include <functional>
#include <vector>

#include "viscera/elasticity/quadratic_mesh.h"

/// Bodies for tests of elasticity.
namespace viscera::test {

/// The unit cube in `cells` boxes, each of six tetrahedra around its diagonal, and every node placed by
/// `place`, those in the middles of edges too: the edges are curved where `place` is.
inline elasticity::QuadraticMesh elasticGrid(const std::array<int, 3>& cells,
                                             const std::function<Vec3(const Vec3&)>& place) {
  const auto [nx, ny, nz] = cells;
  Points points((nx + 1) * (ny + 1) * (nz + 1), 3);
  const auto at = [&](int i, int j, int k) { return (i * (ny + 1) + j) * (nz + 1) + k; };
  for (int i = 0; i <= nx; ++i)
    for (int j = 0; j <= ny; ++j)
      for (int k = 0; k <= nz; ++k)
        points.row(at(i, j, k)) << double(i) / nx, double(j) / ny, double(k) / nz;
  // Paths from the first corner of a box to the last, one axis after the other; odd orders are turned around.
  constexpr int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  deformation::Tetrahedra tetrahedra(6 * nx * ny * nz, 4);
  Eigen::Index next = 0;
  for (int i = 0; i < nx; ++i)
    for (int j = 0; j < ny; ++j)
      for (int k = 0; k < nz; ++k)
        for (int order = 0; order < 6; ++order) {
          std::array<int, 3> corner = {i, j, k};
          for (int c = 0; c < 4; ++c) {
            tetrahedra(next, c) = at(corner[0], corner[1], corner[2]);
            if (c < 3)
              ++corner[std::size_t(orders[order][c])];
          }
          if (order >= 3)
            std::swap(tetrahedra(next, 1), tetrahedra(next, 2));
          ++next;
        }
  elasticity::QuadraticMesh mesh = elasticity::quadraticMesh(points, tetrahedra);
  for (Eigen::Index n = 0; n < mesh.nodes.rows(); ++n)
    mesh.nodes.row(n) = place(mesh.nodes.row(n).transpose()).transpose();
  return mesh;
}

/// The boundary faces all of whose nodes `inside` accepts.
inline std::vector<elasticity::Face> facesWhere(const elasticity::QuadraticMesh& mesh,
                                                const std::function<bool(const Vec3&)>& inside) {
  std::vector<elasticity::Face> faces;
  for (const elasticity::Face& face : elasticity::boundaryFaces(mesh)) {
    bool all = true;
    for (const int local : elasticity::nodesOfFace(face.opposite))
      all = all && inside(mesh.nodes.row(mesh.tetrahedra(face.tetrahedron, local)).transpose());
    if (all)
      faces.push_back(face);
  }
  return faces;
}

/// The node at a place.
inline Eigen::Index nodeAt(const elasticity::QuadraticMesh& mesh, const Vec3& place) {
  Eigen::Index nearest = 0;
  (mesh.nodes.rowwise() - place.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
  return nearest;
}

} // namespace viscera::test
