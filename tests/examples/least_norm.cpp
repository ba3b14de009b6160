#include "least_norm.h"

#include <Eigen/Cholesky>

#include "viscera/coordinates/pointwise_system.h"

namespace viscera::examples {
namespace {

using namespace coordinates;

/// a_i = 1/n + (v_i - m) . C^-1 (p - m), with the handles' mean m and C = sum (v_i - m) (v_i - m)^T: of all a
/// with sum a_i = 1 and sum a_i v_i = p the one of least length. Its derivative is (v_i - m)^T C^-1.
class LeastNorm final : public PointSolver {
public:
  explicit LeastNorm(const Points& handles)
      : mean_(handles.colwise().mean()), spread_(handles.rowwise() - mean_) {
    slopes_ = spread_ * (spread_.transpose() * spread_).inverse();
  }

  bool solve(const Vec3& point, Values& weights) const override {
    weights = slopes_ * (point - mean_.transpose());
    weights.array() += 1.0 / static_cast<double>(weights.size());
    return true; // A system without an answer for this point says false.
  }

  bool solveGradients(const Vec3& point, Values& weights, Points& gradients) const override {
    gradients = slopes_;
    return solve(point, weights);
  }

private:
  Eigen::RowVector3d mean_;
  Points spread_;
  Points slopes_; ///< `n x 3`, 1/mm.
};

} // namespace

std::shared_ptr<const CoordinateSystem> leastNormSystem() {
  Traits traits; // What is promised here, the contract suite tries.
  traits.closedFormGradient = true;
  return std::make_shared<PointwiseSystem>(
      SystemDescription{"least-norm", "Least norm",
                        "The shortest affine combination; fast, global, not positive", traits},
      PointwiseSystem::Prepare([](const HandleSet& handles, const ParameterValues&) {
        return std::make_unique<const LeastNorm>(handles.positions);
      }));
}

} // namespace viscera::examples
