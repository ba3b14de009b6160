#include "motion_modes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Eigenvalues>

namespace viscera::lesson {
namespace {

constexpr Eigen::Index kVertexBlock = 2048;
/// The remainder of an instant, summed over all vertices, below which its motion counts as reproduced, mm.
constexpr double kLeftMm = 1e-3;

/// `W' W` in blocks of vertices whose sums are taken in a fixed order; nothing for carriers that are
/// vertices.
Eigen::MatrixXd gramOfCarriers(const CarrierWeights& weights, Threads threads) {
  if (weights.cols() == 0)
    return {};
  const Eigen::Index blocks = (weights.rows() + kVertexBlock - 1) / kVertexBlock;
  std::vector<Eigen::MatrixXd> parts(static_cast<std::size_t>(blocks));
  parallelRanges(blocks, 1, threads, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index block = begin; block < end; ++block) {
      const Eigen::Index first = block * kVertexBlock;
      const auto rows = weights.middleRows(first, std::min(kVertexBlock, weights.rows() - first));
      Eigen::MatrixXd& part = parts[static_cast<std::size_t>(block)];
      part = Eigen::MatrixXd::Zero(weights.cols(), weights.cols());
      part.selfadjointView<Eigen::Lower>().rankUpdate(rows.transpose());
    }
  });
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(weights.cols(), weights.cols());
  for (const Eigen::MatrixXd& part : parts)
    sum += part;
  return sum.selfadjointView<Eigen::Lower>();
}

/// The Gram matrix of the instants, `<motion of all vertices, motion of all vertices>`, row by row.
class GramRows {
public:
  GramRows(const Instants& instants, const Eigen::MatrixXd& carriers)
      : instants_(instants), x_(weighted(instants.x, carriers)), y_(weighted(instants.y, carriers)),
        z_(weighted(instants.z, carriers)) {}

  Eigen::VectorXd diagonal() const {
    return x_.cwiseProduct(instants_.x).rowwise().sum() + y_.cwiseProduct(instants_.y).rowwise().sum() +
           z_.cwiseProduct(instants_.z).rowwise().sum();
  }
  Eigen::VectorXd row(Eigen::Index i) const {
    return instants_.x * x_.row(i).transpose() + instants_.y * y_.row(i).transpose() +
           instants_.z * z_.row(i).transpose();
  }

private:
  static Table weighted(const Table& axis, const Eigen::MatrixXd& carriers) {
    return carriers.size() > 0 ? Table(axis * carriers) : axis;
  }

  const Instants& instants_;
  Table x_, y_, z_;
};

/// `R` with `R R'` the Gram matrix, but for `kLeftMm` squared on its diagonal: one column for each instant
/// that no combination of those before it tells.
Eigen::MatrixXd factorOf(const GramRows& gram, Progress& progress) {
  // Cholesky with pivoting: r = (G_p - R R_p^T) / sqrt(left_p), and `left`, the diagonal of G - R R^T, is the
  // squared motion that each instant still has to be told.
  Eigen::VectorXd left = gram.diagonal();
  const Eigen::Index most = left.size();
  Eigen::MatrixXd factor(most, 0);
  Eigen::Index pivot = 0;
  while (factor.cols() < most && left.maxCoeff(&pivot) > kLeftMm * kLeftMm) {
    progress.throwIfCancelled();
    Eigen::VectorXd column = gram.row(pivot);
    if (factor.cols() > 0) // A row of a factor without columns has no address.
      column -= factor * factor.row(pivot).transpose();
    column /= std::sqrt(left[pivot]);
    factor.conservativeResize(Eigen::NoChange, factor.cols() + 1);
    factor.rightCols(1) = column;
    left -= column.cwiseAbs2();
    left[pivot] = 0;
  }
  return factor;
}

/// The left singular vectors of `factor`, the strongest first: `instants x rank`.
Eigen::MatrixXd coursesOf(const Eigen::MatrixXd& factor) {
  if (factor.cols() == 0)
    return factor;
  // R^T R = V diag(s^2) V^T gives R = U diag(s) V^T with U = R V diag(1 / s).
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(factor.transpose() * factor);
  const Eigen::Index rank = factor.cols();
  Eigen::MatrixXd courses(factor.rows(), rank);
  for (Eigen::Index k = 0; k < rank; ++k) {
    const Eigen::Index from = rank - 1 - k; // Eigen's are ascending.
    const double strength = std::sqrt(std::max(solver.eigenvalues()[from], 0.0));
    courses.col(k) = strength > 0 ? Eigen::VectorXd(factor * solver.eigenvectors().col(from) / strength)
                                  : Eigen::VectorXd(Eigen::VectorXd::Zero(factor.rows()));
  }
  return courses;
}

/// The motion of the vertices that belongs to one course.
Points modeOf(const Instants& instants, const CarrierWeights& weights, const Eigen::VectorXd& course,
              Threads threads) {
  Points carriers(instants.x.cols(), 3);
  carriers << instants.x.transpose() * course, instants.y.transpose() * course,
      instants.z.transpose() * course;
  if (weights.cols() == 0)
    return carriers;
  Points mode(weights.rows(), 3);
  parallelRanges(weights.rows(), kVertexBlock, threads, [&](Eigen::Index begin, Eigen::Index end) {
    mode.middleRows(begin, end - begin) = weights.middleRows(begin, end - begin) * carriers;
  });
  return mode;
}

double largestNorm(const Points& mode) {
  return mode.rows() == 0 ? 0 : mode.rowwise().norm().maxCoeff();
}

} // namespace

MotionModes modesOf(const Instants& instants, const CarrierWeights& weights, double toleranceMm,
                    Progress& progress, Threads threads) {
  const GramRows gram(instants, gramOfCarriers(weights, threads));
  progress.throwIfCancelled();
  const Eigen::MatrixXd courses = coursesOf(factorOf(gram, progress));
  MotionModes result;
  for (Eigen::Index k = 0; k < courses.cols(); ++k) {
    progress.throwIfCancelled();
    result.modes.push_back(modeOf(instants, weights, courses.col(k), threads));
  }
  // The error of left out modes is at most the sum of their largest contributions.
  std::vector<double> strongest;
  for (Eigen::Index k = 0; k < courses.cols(); ++k) {
    const double size = courses.col(k).cwiseAbs().maxCoeff();
    result.modes[static_cast<std::size_t>(k)] *= size;
    strongest.push_back(largestNorm(result.modes[static_cast<std::size_t>(k)]));
  }
  double left = 0;
  while (!strongest.empty() && left + strongest.back() <= toleranceMm) {
    left += strongest.back();
    strongest.pop_back();
  }
  result.modes.resize(strongest.size());
  result.course = courses.leftCols(static_cast<Eigen::Index>(strongest.size()));
  for (Eigen::Index k = 0; k < result.course.cols(); ++k)
    result.course.col(k) /= result.course.col(k).cwiseAbs().maxCoeff();
  return result;
}

LargestDifference largestDifference(const std::vector<Points>& modes, const Table& differences) {
  Eigen::VectorXd sizes(differences.cols());
  for (Eigen::Index k = 0; k < sizes.size(); ++k)
    sizes[k] = largestNorm(modes[static_cast<std::size_t>(k)]);
  const Eigen::VectorXd bounds = differences.cwiseAbs() * sizes;
  std::vector<Eigen::Index> order(static_cast<std::size_t>(bounds.size()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    return std::pair(bounds[b], a) < std::pair(bounds[a], b);
  });
  LargestDifference largest;
  for (const Eigen::Index row : order) {
    if (bounds[row] <= largest.mm)
      break;
    Points off = Points::Zero(modes.front().rows(), 3);
    for (Eigen::Index k = 0; k < sizes.size(); ++k)
      off += differences(row, k) * modes[static_cast<std::size_t>(k)];
    if (const double mm = largestNorm(off); mm > largest.mm)
      largest = {mm, row};
  }
  return largest;
}

} // namespace viscera::lesson
