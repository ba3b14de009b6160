#include "fold_relief.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Cholesky>

namespace viscera::tracking {
namespace {

constexpr double kFlat = 0.03, kWantedRatio = 0.05;
constexpr int kRounds = 25;
constexpr double kLongestMm = 3; ///< That a vertex moves in a round: det F is cubic in the pose.
constexpr double kRidge = 1e-9;  ///< Of the largest entry: neighbours say nearly the same.

/// The witnesses that must not fold, and the cheapest ways to change det F there.
class FoldRows {
public:
  FoldRows(const WallStiffness& stiffness, const Metric& metric, const std::vector<Eigen::Index>& witnesses,
           const Points& pose)
      : metric_(metric) {
    const Eigen::Index count = static_cast<Eigen::Index>(witnesses.size()), size = pose.size();
    slopes_.resize(size, count);
    ways_.resize(size, count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const Points slope = stiffness.witnessGradient(pose, witnesses[static_cast<std::size_t>(i)]);
      const Points way = metric(slope);
      slopes_.col(i) = slope.reshaped();
      ways_.col(i) = way.reshaped();
    }
    Eigen::MatrixXd products = slopes_.transpose() * ways_;
    products.diagonal().array() += kRidge * products.diagonal().maxCoeff();
    products_.compute(products);
  }
  /// The cheapest change of a pose by which det F changes so.
  Points change(const Values& ratios) const {
    return (ways_ * products_.solve(ratios)).reshaped(slopes_.rows() / 3, 3);
  }
  /// The metric's answer without what changes det F.
  Points beside(const Points& gradient) const {
    const Points way = metric_(gradient);
    return way - change(slopes_.transpose() * way.reshaped());
  }

private:
  const Metric& metric_;
  Eigen::MatrixXd slopes_, ways_; ///< Columns of stacked poses.
  Eigen::LDLT<Eigen::MatrixXd> products_;
};

} // namespace

bool isFolded(const WallStiffness& stiffness, const Points& pose) {
  return (stiffness.witnessRatios(pose).array() <= 0).any();
}

bool relieveFolds(const MotionRig& rig, const WallStiffness& stiffness, const Metric& metric,
                  bool keepVolumes, Points& pose) {
  if (!isFolded(stiffness, pose))
    return true;
  const Values volumes = rig.volumesMl(rig.vertices(pose));
  Points free = pose;
  std::vector<Eigen::Index> witnesses;
  for (int round = 0; round < kRounds; ++round) {
    const Values ratios = stiffness.witnessRatios(free);
    for (Eigen::Index i = 0; i < ratios.size(); ++i)
      if (ratios[i] < kFlat && std::find(witnesses.begin(), witnesses.end(), i) == witnesses.end())
        witnesses.push_back(i);
    const FoldRows rows(stiffness, metric, witnesses, free);
    const Values missing = (kWantedRatio - ratios(witnesses).array()).cwiseMax(0);
    const Points change = rows.change(missing);
    const double largest = std::sqrt(rig.vertices(change).rowwise().squaredNorm().maxCoeff());
    free += std::min(1.0, kLongestMm / std::max(largest, 1e-9)) * change;
    bool met = true;
    if (keepVolumes)
      met = solveVolumes(
                rig, volumes, [&](const Points& gradient) { return rows.beside(gradient); }, free)
                .met;
    if (met && free.allFinite() && !isFolded(stiffness, free)) {
      pose = free;
      return true;
    }
  }
  return false;
}

} // namespace viscera::tracking
