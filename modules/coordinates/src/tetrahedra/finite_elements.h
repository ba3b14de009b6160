#pragma once

#include <vector>

#include <Eigen/SparseCore>

#include "viscera/coordinates/tetrahedraliser.h"
#include "viscera/core/parallel.h"

namespace viscera::coordinates {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// Gradients of the four barycentric coordinates of a tetrahedron, a row a corner (`4 x 3`, 1/mm).
Eigen::Matrix<double, 4, 3> barycentricGradients(const SolidMesh& mesh, Eigen::Index tetrahedron);

/// The matrix of Dirichlet's energy `1/2 int |grad u|^2` of piecewise linear functions, `n x n`, mm.
SparseMatrix stiffness(const SolidMesh& mesh);

/// The volume that belongs to each corner: a quarter of each tetrahedron around it, mm^3.
Values lumpedMass(const SolidMesh& mesh);

/// The columns of values (`n x k`) of least energy that have the values `given` (`fixed x k`) at the corners
/// `fixed` (ascending). By a sparse Cholesky factorisation. Throws `DataError` where the energy does not
/// determine them. Bitwise independent of the number of threads.
Eigen::MatrixXd leastEnergy(const SparseMatrix& energy, const std::vector<Eigen::Index>& fixed,
                            const Eigen::MatrixXd& given, Threads threads, Progress& progress);

} // namespace viscera::coordinates
