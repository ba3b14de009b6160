#include "anderson.h"

#include <Eigen/QR>

namespace viscera::circulation {
namespace {
/// Directions that add less than this to the others are left out of the mixture.
constexpr double kRankTolerance = 1e-9;
} // namespace

Eigen::VectorXd Anderson::next(const Eigen::VectorXd& x, const Eigen::VectorXd& image,
                               const Eigen::VectorXd& weights) {
  // f_j = w (g(x_j) - x_j) by components.
  images_.push_back(image);
  residuals_.push_back(weights.cwiseProduct(image - x));
  if (static_cast<int>(images_.size()) > depth_ + 1) {
    images_.pop_front();
    residuals_.pop_front();
  }
  const Eigen::Index others = static_cast<Eigen::Index>(images_.size()) - 1;
  if (others == 0)
    return image;
  // min | f_k - sum c_j (f_k - f_j) |: the weights of the mixture then sum to 1 by construction.
  Eigen::MatrixXd differences(x.size(), others);
  for (Eigen::Index j = 0; j < others; ++j)
    differences.col(j) = residuals_.back() - residuals_[static_cast<std::size_t>(j)];
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(differences);
  solver.setThreshold(kRankTolerance);
  const Eigen::VectorXd shares = solver.solve(residuals_.back());
  // x = sum a_j g(x_j) = g_k - sum c_j (g_k - g_j), with a_j = c_j for the others and a_k = 1 - sum c_j.
  Eigen::VectorXd mixed = image;
  for (Eigen::Index j = 0; j < others; ++j)
    mixed -= shares[j] * (image - images_[static_cast<std::size_t>(j)]);
  return mixed;
}

void Anderson::restart() {
  images_.clear();
  residuals_.clear();
}

} // namespace viscera::circulation
