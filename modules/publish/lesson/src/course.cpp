#include "viscera/lesson/course.h"

#include <algorithm>
#include <utility>

#include <Eigen/SparseCholesky>

namespace viscera::lesson {
namespace {

using Index = Eigen::Index;

/// Where the rows of the slopes' equations are: of a cycle the last instant is the first one.
struct Equations {
  Index count;
  std::vector<Eigen::Triplet<double>> entries;
  Table right;

  /// Adds what the piece from instant `i` to `j`, `length` long, asks of the slopes at both.
  void addPiece(Index i, Index j, double length, const Eigen::RowVectorXd& rise) {
    for (const auto& [row, column] : {std::pair(i, j), std::pair(j, i)}) {
      entries.emplace_back(row, row, 2 / length);
      entries.emplace_back(row, column, 1 / length);
      right.row(row) += 3 * rise / (length * length);
    }
  }
};

} // namespace

double fractionOf(Index sample, Index samples, CourseEnd end) {
  const Index steps = end == CourseEnd::cycles ? samples : std::max<Index>(1, samples - 1);
  return static_cast<double>(sample) / static_cast<double>(steps);
}

Course splineThrough(std::vector<double> instants, Table values, CourseEnd end) {
  const auto pieces = static_cast<Index>(instants.size()) - 1;
  const bool cycles = end == CourseEnd::cycles;
  Equations equations{cycles ? pieces : pieces + 1, {}, {}};
  equations.right = Table::Zero(equations.count, values.cols());
  for (Index i = 0; i < pieces; ++i) {
    const auto place = static_cast<std::size_t>(i);
    equations.addPiece(i, (i + 1) % equations.count, instants[place + 1] - instants[place],
                       values.row(i + 1) - values.row(i));
  }
  Eigen::SparseMatrix<double> matrix(equations.count, equations.count);
  matrix.setFromTriplets(equations.entries.begin(), equations.entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  Table slopes(pieces + 1, values.cols());
  slopes.topRows(equations.count) = solver.solve(Eigen::MatrixXd(equations.right));
  if (cycles)
    slopes.row(pieces) = slopes.row(0);
  return {std::move(instants), std::move(values), std::move(slopes)};
}

Eigen::VectorXd valueAt(const Course& course, double fraction) {
  const std::vector<double>& at = course.instants;
  const auto next =
      std::clamp(std::upper_bound(at.begin(), at.end(), fraction), at.begin() + 1, at.end() - 1);
  const Index j = next - at.begin(), i = j - 1;
  const double length = *next - *(next - 1), u = (fraction - *(next - 1)) / length, v = 1 - u;
  return v * v * (1 + 2 * u) * course.values.row(i) + u * u * (3 - 2 * u) * course.values.row(j) +
         length * u * v * (v * course.slopes.row(i) - u * course.slopes.row(j));
}

} // namespace viscera::lesson
