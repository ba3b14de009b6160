#include "celestial/celestial_function.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

namespace viscera::coordinates {
namespace {

using Mat3 = Eigen::Matrix3d;

constexpr Eigen::Index kGradientsAtOnce = 256;

/// The contribution of one handle at one point. The prior weights are `D^-k` here: a common factor changes
/// nothing.
struct Seen {
  Vec3 q;
  double inverse = 0; ///< 1 / D.
  double first = 0;   ///< m phi'.
  double second = 0;  ///< m phi''.
};

/// The derivatives at one point, written to `gradients` (`handles x 3`). Differentiates the condition
/// `sum m_i phi'(q_i . x) q_i = 0` for dx/dp, with `dq/dp = -(I - q q^T) / D` and `dm/dp = k m q^T / D`, then
/// the coordinates by the quotient rule.
class PointGradient {
public:
  PointGradient(const CelestialFunction& function, const CelestialOptions& options, Eigen::Index handles)
      : function_(function), options_(options), seen_(static_cast<std::size_t>(handles)) {}

  template <class Rows>
  void compute(const Points& handles, const Vec3& point, const Vec3& x, Rows&& gradients) {
    look(handles, point, x);
    const Mat3 change = solutionDerivative(x);
    double total = 0;
    Eigen::RowVector3d totalGradient = Eigen::RowVector3d::Zero();
    for (Eigen::Index i = 0; i < handles.rows(); ++i) {
      const Seen& seen = seen_[static_cast<std::size_t>(i)];
      // d(beta / D), beta = m phi'(q.x): the prior's part, the argument's part, and that of 1 / D.
      const Eigen::RowVector3d argument = seen.q.transpose() * change + directionPart(seen, x);
      gradients.row(i) = seen.inverse * (seen.second * argument + (options_.locality + 1) * seen.first *
                                                                      seen.inverse * seen.q.transpose());
      total += seen.first * seen.inverse;
      totalGradient += gradients.row(i);
    }
    for (Eigen::Index i = 0; i < handles.rows(); ++i) {
      const Seen& seen = seen_[static_cast<std::size_t>(i)];
      gradients.row(i) = (gradients.row(i) - seen.first * seen.inverse / total * totalGradient) / total;
    }
  }

private:
  /// x^T dq/dp.
  static Eigen::RowVector3d directionPart(const Seen& seen, const Vec3& x) {
    return seen.inverse * (seen.q.dot(x) * seen.q - x).transpose();
  }

  void look(const Points& handles, const Vec3& point, const Vec3& x) {
    double nearest = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < handles.rows(); ++i) {
      Seen& seen = seen_[static_cast<std::size_t>(i)];
      const Vec3 offset = handles.row(i).transpose() - point;
      const double distance = std::hypot(offset.norm(), options_.softness);
      seen.q = offset / distance;
      seen.inverse = 1 / distance;
      nearest = std::min(nearest, distance);
    }
    for (Seen& seen : seen_) {
      const double prior = std::pow(nearest * seen.inverse, options_.locality);
      const double t = seen.q.dot(x);
      seen.first = prior * function_.first(t);
      seen.second = prior * function_.second(t);
    }
  }

  Mat3 solutionDerivative(const Vec3& x) const {
    Mat3 hessian = Mat3::Zero(), mixed = Mat3::Zero();
    for (const Seen& seen : seen_) {
      const Mat3 outer = seen.q * seen.q.transpose();
      hessian += seen.second * outer;
      mixed += seen.second * seen.q * directionPart(seen, x) +
               seen.first * seen.inverse * ((1 + options_.locality) * outer - Mat3::Identity());
    }
    return -hessian.ldlt().solve(mixed);
  }

  const CelestialFunction& function_;
  const CelestialOptions& options_;
  std::vector<Seen> seen_;
};

/// Points at which a handle has coordinate 1.
std::vector<int> pointsAtHandles(const TiledWeights& weights) {
  std::vector<int> found;
  for (Eigen::Index point = 0; point < weights.points(); ++point)
    for (Eigen::Index handle = 0; handle < weights.handles(); ++handle)
      if (weights(point, handle) == 1)
        found.push_back(static_cast<int>(point));
  return found;
}

} // namespace

CoordinateGradients celestialGradients(const CelestialFunction& function, const Points& handles,
                                       const Points& points, const CelestialOptions& options,
                                       CelestialSolution<3>& solution) {
  CoordinateGradients result;
  result.closedForm = true;
  result.failures = std::move(solution.failures);
  if (options.softness == 0) {
    const std::vector<int> kinks = pointsAtHandles(solution.weights);
    const auto middle = result.failures.insert(result.failures.end(), kinks.begin(), kinks.end());
    std::inplace_merge(result.failures.begin(), middle, result.failures.end());
  }
  const Eigen::Index count = handles.rows();
  result.values.setZero(points.rows() * count, 3);
  parallelRanges(points.rows(), kGradientsAtOnce, options.threads, [&](Eigen::Index begin, Eigen::Index end) {
    PointGradient gradient(function, options, count);
    for (Eigen::Index point = begin; point < end; ++point)
      if (!std::binary_search(result.failures.begin(), result.failures.end(), static_cast<int>(point)))
        gradient.compute(handles, points.row(point).transpose(), solution.x.row(point).transpose(),
                         result.values.middleRows(point * count, count));
  });
  return result;
}

} // namespace viscera::coordinates
