#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/deformation/witness_mesh.h"

/// Tetrahedra with ten nodes, on which displacements are quadratic.
namespace viscera::elasticity {

/// `t x 10` nodes of tetrahedra, row major: four corners, then the middles of the edges 01, 12, 02, 03, 13,
/// 23 (the order of VTK's `VTK_QUADRATIC_TETRA`).
using QuadraticTetrahedra = Eigen::Matrix<std::int32_t, Eigen::Dynamic, 10, Eigen::RowMajor>;

/// The corners of each edge, in the order of the nodes 4 to 9.
inline constexpr std::array<std::array<int, 2>, 6> kEdges = {
    {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}}};

/// A mesh of quadratic tetrahedra. Nodes [0, corners) are corners; a curved edge has its node off the middle.
struct QuadraticMesh {
  Points nodes; ///< `n x 3`, mm, at rest.
  QuadraticTetrahedra tetrahedra;
  Eigen::Index corners = 0;
};

/// The mesh with a node in the middle of each edge. `tetrahedra` are positive and use every row of `points`.
/// O(t log t).
QuadraticMesh quadraticMesh(const Points& points, const deformation::Tetrahedra& tetrahedra);

/// A face of a tetrahedron: its row, and the corner (0 to 3) that is not on the face.
struct Face {
  std::int32_t tetrahedron = 0;
  int opposite = 0;
};

/// The local numbers of a face's six nodes: three corners, counter-clockwise seen from outside, and the
/// middles of the edges between first and second, second and third, third and first.
std::array<int, 6> nodesOfFace(int opposite);

/// The faces that belong to one tetrahedron only, in the order of the tetrahedra. O(t log t).
std::vector<Face> boundaryFaces(const QuadraticMesh& mesh);

} // namespace viscera::elasticity
