#pragma once

#include <vector>

#include <Eigen/SparseCore>

namespace viscera::coordinates {

/// The rows and columns of a symmetric matrix, divided into what is free and what is fixed.
struct SplitSystem {
  /// `fixed` ascending.
  SplitSystem(const Eigen::SparseMatrix<double>& matrix, const std::vector<Eigen::Index>& fixed);

  std::vector<Eigen::Index> free;            ///< Ascending.
  Eigen::SparseMatrix<double> amongFree;     ///< `free x free`.
  Eigen::SparseMatrix<double> freeWithFixed; ///< `free x fixed`.
};

} // namespace viscera::coordinates
