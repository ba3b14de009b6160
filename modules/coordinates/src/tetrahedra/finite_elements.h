#pragma once

#include <string>
#include <vector>

#include <Eigen/SparseCore>

#include "viscera/coordinates/coordinate_system.h"

/// Linear finite elements on a tetrahedral mesh of the space inside a cage or hull.
namespace viscera::coordinates {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// A tetrahedral mesh of a domain whose long edges were split.
struct FilledDomain {
  Eigen::Index onSurface; ///< The first points of `solid` lie on the domain's surface.
  SolidMesh solid;
};

/// Fills `surface` with tetrahedra, whose edges are split to a `resolution`-th of the surface's diagonal, and
/// makes the points `inside` (`k x 3`, mm) corners, directly after those of the surface. Throws `UsageError`
/// that names `system` if `options` have no mesher, and what the mesher throws.
FilledDomain filledDomain(const geometry::TriangleMesh& surface, const Points& inside, double resolution,
                          const std::string& system, const BindOptions& options, Progress& progress);

/// The number of edges across the domain, for both systems.
Parameter resolutionParameter(double maximum, double standard);

/// Gradients of the four barycentric coordinates of a tetrahedron, a row for each corner (`4 x 3`, 1/mm).
Eigen::Matrix<double, 4, 3> barycentricGradients(const SolidMesh& mesh, Eigen::Index tetrahedron);

/// The matrix of Dirichlet's energy `1/2 int |grad u|^2` of piecewise linear functions, `n x n`, mm.
SparseMatrix stiffness(const SolidMesh& mesh);

/// The volume that belongs to each corner: a quarter of each tetrahedron around it, mm^3.
Values lumpedMass(const SolidMesh& mesh);

/// A symmetric matrix with its rows and columns divided into free and fixed ones.
struct SplitSystem {
  /// `fixed` ascending.
  SplitSystem(const SparseMatrix& matrix, const std::vector<Eigen::Index>& fixed);

  std::vector<Eigen::Index> free; ///< Ascending.
  SparseMatrix amongFree;         ///< `free x free`.
  SparseMatrix freeWithFixed;     ///< `free x fixed`.
};

/// The columns of values (`n x k`) of least energy that have the values `given` (`fixed x k`) at the corners
/// `fixed` (ascending). By a sparse Cholesky factorisation. Throws `DataError` where the energy does not
/// determine them. Bitwise independent of the number of threads.
Eigen::MatrixXd leastEnergy(const SparseMatrix& energy, const std::vector<Eigen::Index>& fixed,
                            const Eigen::MatrixXd& given, Threads threads, Progress& progress);

} // namespace viscera::coordinates
