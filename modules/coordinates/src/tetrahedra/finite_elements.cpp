#include "tetrahedra/finite_elements.h"

#include <cmath>

#include <Eigen/LU>
#include <Eigen/SparseCholesky>

#include "choice_parameter.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/split_edges.h"

namespace viscera::coordinates {
namespace {

constexpr int kMostTriangles = 200'000;
/// Volume of a tetrahedron with edges of length 1, as a quality mesh has them on the average.
constexpr double kVolumeOfUnitEdges = 0.125;

Eigen::Matrix3d edgesOf(const SolidMesh& mesh, Eigen::Index tetrahedron) {
  Eigen::Matrix3d edges;
  for (int k = 0; k < 3; ++k)
    edges.col(k) = (mesh.points.row(mesh.tetrahedra(tetrahedron, k + 1)) -
                    mesh.points.row(mesh.tetrahedra(tetrahedron, 0)))
                       .transpose();
  return edges;
}

double volumeOf(const SolidMesh& mesh, Eigen::Index tetrahedron) {
  return std::abs(edgesOf(mesh, tetrahedron).determinant()) / 6;
}

} // namespace

FilledDomain filledDomain(const geometry::TriangleMesh& surface, const Points& inside, double resolution,
                          const std::string& system, const BindOptions& options, Progress& progress) {
  if (!options.tetrahedralise)
    throw UsageError(misuse("%1 need tetrahedra, which cannot be made here", named(system)), {},
                     misuse("bind by way of the deformation module, or choose another system"));
  const double edge = boundsOf(surface.points).diagonal() / resolution;
  geometry::TriangleMesh cut = geometry::splitLongEdges(surface, edge, kMostTriangles);
  FilledDomain domain{cut.points.rows(), {}};
  cut.points.conservativeResize(domain.onSurface + inside.rows(), 3);
  cut.points.bottomRows(inside.rows()) = inside;
  progress.report(0, "filling the handles with tetrahedra");
  domain.solid = options.tetrahedralise(cut, kVolumeOfUnitEdges * edge * edge * edge, progress);
  return domain;
}

Parameter resolutionParameter(double maximum, double standard) {
  return countParameter("resolution", "Edges of tetrahedra across the handles; more are finer and slower", 4,
                        maximum, standard);
}

Eigen::Matrix<double, 4, 3> barycentricGradients(const SolidMesh& mesh, Eigen::Index tetrahedron) {
  Eigen::Matrix<double, 4, 3> gradients;
  // x = v_0 + E (lambda_1, lambda_2, lambda_3) with the edges from v_0 as columns of E: the gradients are the
  // rows of E^-1. The four coordinates sum to 1, so their gradients sum to zero.
  gradients.bottomRows<3>() = edgesOf(mesh, tetrahedron).inverse();
  gradients.row(0) = -gradients.bottomRows<3>().colwise().sum();
  return gradients;
}

SparseMatrix stiffness(const SolidMesh& mesh) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(16 * static_cast<std::size_t>(mesh.tetrahedra.rows()));
  for (Eigen::Index t = 0; t < mesh.tetrahedra.rows(); ++t) {
    const auto gradients = barycentricGradients(mesh, t);
    // K_ij = int grad lambda_i . grad lambda_j = sum_t V_t grad lambda_i . grad lambda_j, constant in each
    // tetrahedron; then u^T K u / 2 is Dirichlet's energy.
    const Eigen::Matrix4d local = volumeOf(mesh, t) * gradients * gradients.transpose();
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        entries.emplace_back(mesh.tetrahedra(t, i), mesh.tetrahedra(t, j), local(i, j));
  }
  SparseMatrix matrix(mesh.points.rows(), mesh.points.rows());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Values lumpedMass(const SolidMesh& mesh) {
  // M_i = int lambda_i = sum_t V_t / 4: the rows of the full mass matrix int lambda_i lambda_j summed,
  // because the lambda_j sum to 1.
  Values mass = Values::Zero(mesh.points.rows());
  for (Eigen::Index t = 0; t < mesh.tetrahedra.rows(); ++t)
    for (int k = 0; k < 4; ++k)
      mass[mesh.tetrahedra(t, k)] += volumeOf(mesh, t) / 4;
  return mass;
}

SplitSystem::SplitSystem(const SparseMatrix& matrix, const std::vector<Eigen::Index>& fixed) {
  using Triplet = Eigen::Triplet<double>;
  std::vector<int> freeRow(static_cast<std::size_t>(matrix.rows()), -1), fixedRow = freeRow;
  for (std::size_t i = 0; i < fixed.size(); ++i)
    fixedRow[static_cast<std::size_t>(fixed[i])] = static_cast<int>(i);
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    if (fixedRow[static_cast<std::size_t>(i)] < 0) {
      freeRow[static_cast<std::size_t>(i)] = static_cast<int>(free.size());
      free.push_back(i);
    }
  std::vector<Triplet> inner, outer;
  for (Eigen::Index column = 0; column < matrix.outerSize(); ++column)
    for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry) {
      const int row = freeRow[static_cast<std::size_t>(entry.row())];
      if (row < 0)
        continue;
      const int own = freeRow[static_cast<std::size_t>(column)];
      if (own >= 0)
        inner.emplace_back(row, own, entry.value());
      else
        outer.emplace_back(row, fixedRow[static_cast<std::size_t>(column)], entry.value());
    }
  const auto rows = static_cast<Eigen::Index>(free.size());
  amongFree.resize(rows, rows);
  amongFree.setFromTriplets(inner.begin(), inner.end());
  freeWithFixed.resize(rows, static_cast<Eigen::Index>(fixed.size()));
  freeWithFixed.setFromTriplets(outer.begin(), outer.end());
}

Eigen::MatrixXd leastEnergy(const SparseMatrix& energy, const std::vector<Eigen::Index>& fixed,
                            const Eigen::MatrixXd& given, Threads threads, Progress& progress) {
  // u^T K u / 2 is least over the free values u_f, with the fixed ones u_b given, where K_ff u_f = -K_fb u_b.
  const SplitSystem split(energy, fixed);
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(energy.rows(), given.cols());
  for (std::size_t i = 0; i < fixed.size(); ++i)
    values.row(fixed[i]) = given.row(static_cast<Eigen::Index>(i));
  if (split.free.empty())
    return values;
  progress.throwIfCancelled();
  const Eigen::SimplicialLDLT<SparseMatrix> factor(split.amongFree);
  if (factor.info() != Eigen::Success)
    throw DataError(misuse("the tetrahedra do not determine the coordinates"), "the handles' tetrahedra",
                    "try another resolution");
  const Eigen::MatrixXd pulled = -(split.freeWithFixed * given);
  parallelRanges(given.cols(), 1, threads, [&](Eigen::Index column, Eigen::Index) {
    progress.throwIfCancelled();
    const Values solved = factor.solve(pulled.col(column));
    for (std::size_t i = 0; i < split.free.size(); ++i)
      values(split.free[i], column) = solved[static_cast<Eigen::Index>(i)];
  });
  return values;
}

} // namespace viscera::coordinates
