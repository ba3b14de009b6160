#pragma once

#include <Eigen/Core>
#include <deque>

namespace viscera::circulation {

/// Anderson's acceleration of a fixed-point iteration x <- g(x) (Walker and Ni 2011, doi 10.1137/10078356X):
/// the next x is the mixture of the last images, with weights that sum to 1, whose mixed residual is least.
/// The mixture keeps every linear quantity that g keeps. One thread.
class Anderson {
public:
  /// Remembers so many iterations.
  explicit Anderson(int depth) : depth_(depth) {}

  /// The next place to try, given g at the last one. `weights` scales the residual's components.
  Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& image,
                       const Eigen::VectorXd& weights);

  /// Forgets everything: the next step is plain.
  void restart();

private:
  int depth_;
  std::deque<Eigen::VectorXd> images_, residuals_;
};

} // namespace viscera::circulation
