#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/elasticity/static_solution.h"

namespace viscera::elasticity {

/// The linear systems of Newton's method: the unknowns that are not prescribed, with a pattern that is made
/// once.
class SparseSystem {
public:
  /// `isFree` marks the unknowns of the body that are not prescribed.
  SparseSystem(const ElasticBody& body, const std::vector<bool>& isFree, const Loads& loads);

  /// What `assemble` finds beside the system.
  struct Sums {
    Values force;      ///< Of all unknowns, prescribed ones too: out of balance.
    Values inner;      ///< The same without the pressures' share.
    double energy = 0; ///< kPa mm^3.
    double smallestJacobian = 1;
  };

  /// Assembles forces and stiffness at `state`, the pressures times `part`. `ahead` is a change of the
  /// prescribed unknowns that the right-hand side anticipates.
  Sums assemble(const Values& state, double part, const Values& ahead, Threads threads, Progress& progress);

  /// The Newton step of all unknowns, `ahead` in the prescribed ones; empty when the system is singular.
  Values step(const Values& ahead);

private:
  void makePattern();
  void scatter(Eigen::Index tetrahedron, const ElementShare& share);

  const ElasticBody& body_;
  const Loads& loads_;
  std::vector<Eigen::Index> names_; ///< The row of each unknown in the system, or -1.
  Eigen::Index size_ = 0;
  std::vector<std::vector<std::int32_t>> pressed_; ///< Of each tetrahedron: faces, as `pressures` and row.
  std::vector<std::int32_t> slots_;                ///< Places in the values of each tetrahedron's share.
  Eigen::SparseMatrix<double> matrix_;             ///< Lower triangle.
  Values right_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> factors_;
  bool analysed_ = false;
};

} // namespace viscera::elasticity
