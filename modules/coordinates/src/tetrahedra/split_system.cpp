#include "tetrahedra/split_system.h"

namespace viscera::coordinates {

SplitSystem::SplitSystem(const Eigen::SparseMatrix<double>& matrix, const std::vector<Eigen::Index>& fixed) {
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
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column); entry; ++entry) {
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

} // namespace viscera::coordinates
