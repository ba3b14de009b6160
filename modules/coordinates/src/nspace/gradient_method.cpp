#include "viscera/coordinates/systems.h"

#include <algorithm>
#include <limits>
#include <random>
#include <utility>

#include <Eigen/LU>

#include "choice_parameter.h"
#include "nspace/direction_solver.h"
#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {
namespace {

enum class Stop { inside, highest };

const Parameter kStop =
    choiceParameter("stop", "When the ascent of the smallest number ends", {"inside", "highest"});
const Parameter kGradientSeed =
    countParameter("seed", "0 starts from all ones, others from random numbers", 0, 1e6, 1);

/// Part of one: a smaller rise of the smallest number is none.
constexpr double kStill = 1e-12;

/// Where a balanced vector goes when its tied numbers are raised together, staying balanced and tied. What is
/// maximised is `min_i beta_i` under `sum beta_i u_i = 0`. The gradient is taken as 1 for the tied numbers
/// and 0 for the others; the way is the gradient's projection onto the balanced vectors whose tied numbers
/// are equal (thesis 3.3.4 and 3.31).
template <int Dim>
class Ascent {
public:
  Ascent(const PointsOf<Dim>& units, Values start) : units_(units), values_(std::move(start)) {
    tied_.assign(static_cast<std::size_t>(values_.size()), false);
    values_.minCoeff(&last_);
    tied_[static_cast<std::size_t>(last_)] = true;
  }

  double smallest() const { return values_[last_]; }
  double rate() const { return direction_[last_]; }
  const Values& values() const { return values_; }
  const Values& direction() const { return direction_; }

  /// False when the tied numbers cannot be raised.
  bool findDirection() {
    Matrix outer = Matrix::Zero();
    Vector sum = Vector::Zero();
    double count = 0;
    for (Eigen::Index i = 0; i < values_.size(); ++i) {
      const Vector unit = units_.row(i).transpose();
      if (tied(i)) {
        sum += unit;
        ++count;
      } else {
        outer += unit * unit.transpose();
      }
    }
    // Let s = sum of the k tied u_i and G = sum of the free u_i u_i^T + s s^T / k, the way is
    // -u_i.G^-1 s for a free number and 1 - s.G^-1 s / k for all tied ones; it keeps sum beta_i u_i = 0.
    outer += sum * sum.transpose() / count;
    Matrix inverse;
    double determinant = 0;
    bool invertible = false;
    outer.computeInverseAndDetWithCheck(inverse, determinant, invertible, kStill);
    if (!invertible)
      return false;
    const Vector pull = inverse * sum;
    direction_ = -units_ * pull;
    const double together = 1 - sum.dot(pull) / count;
    for (Eigen::Index i = 0; i < values_.size(); ++i)
      if (tied(i))
        direction_[i] = together;
    return together > kStill;
  }

  /// How far to the next tie, and with whom; -1 when there is none.
  std::pair<double, Eigen::Index> nextTie() const {
    // beta_i + s way_i = smallest + s rate.
    std::pair<double, Eigen::Index> next{std::numeric_limits<double>::infinity(), -1};
    for (Eigen::Index i = 0; i < values_.size(); ++i) {
      const double closing = rate() - direction_[i];
      if (!tied(i) && closing > kStill && (values_[i] - smallest()) / closing < next.first)
        next = {(values_[i] - smallest()) / closing, i};
    }
    return next;
  }

  void move(double distance) { values_ += distance * direction_; }
  void tie(Eigen::Index handle) {
    tied_[static_cast<std::size_t>(handle)] = true;
    values_[handle] = smallest();
  }

private:
  using Vector = Eigen::Matrix<double, Dim, 1>;
  using Matrix = Eigen::Matrix<double, Dim, Dim>;

  bool tied(Eigen::Index i) const { return tied_[static_cast<std::size_t>(i)]; }

  const PointsOf<Dim>& units_;
  Values values_;
  Values direction_;
  std::vector<bool> tied_;
  Eigen::Index last_ = 0; ///< One of the tied.
};

/// Raises the smallest number of the balanced vector nearest to `start`.
template <int Dim>
bool ascend(const HandleDirectionsOf<Dim>& sight, const Values& start, Stop stop, Values& beta) {
  const BalancedSpace<Dim> space(sight.units);
  if (!space.valid())
    return false;
  Ascent<Dim> ascent(sight.units, space.project(start));
  while ((stop == Stop::highest || ascent.smallest() < 0) && ascent.findDirection()) {
    const auto [distance, handle] = ascent.nextTie();
    // smallest + s rate = 0.
    const double toZero = -ascent.smallest() / ascent.rate();
    if (stop == Stop::inside && toZero <= distance) {
      ascent.move(toZero);
      break;
    }
    if (handle < 0) { // It rises for ever: the start is forgotten.
      beta = ascent.direction();
      return true;
    }
    ascent.move(distance);
    ascent.tie(handle);
  }
  beta = ascent.values();
  if (beta.minCoeff() < -kStill * beta.maxCoeff())
    return false;
  beta = beta.cwiseMax(0);
  return true;
}

Values startOf(Eigen::Index handles, const ParameterValues& parameters) {
  const auto seed = static_cast<unsigned>(parameters.get(kGradientSeed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(0, 1);
  Values start = Values::Ones(handles);
  for (Eigen::Index i = 0; seed != 0 && i < handles; ++i)
    start[i] = number(random);
  return start;
}

template <int Dim>
BalanceIn<Dim> ascentOf(Eigen::Index handles, const ParameterValues& parameters) {
  return [stop = chosen<Stop>(parameters, kStop),
          start = startOf(handles, parameters)](const HandleDirectionsOf<Dim>& sight, Values& beta) {
    return ascend<Dim>(sight, start, stop, beta);
  };
}

} // namespace

BalanceIn<2> planeGradient(Eigen::Index handles, const ParameterValues& parameters) {
  return ascentOf<2>(handles, parameters);
}

/// Coordinates by gradient ascent: raises the smallest number of a balanced vector along its steepest
/// direction; where others tie with it they are raised together (thesis 3.3.4). Parameters:
/// * `stop`: `inside` stops as soon as no number is negative; `highest` goes on until the smallest number no
///   longer rises, and takes the direction if it rises without limit. The thesis describes both. It promises
///   continuity, which holds for `inside`; `highest` jumps where the order of the ties changes.
/// * `seed`: of the random positive vector whose projection is the start, the same for all points; 0 starts
///   from all ones.
///
/// Points at which the ascent ends with a negative number have no coordinates. O(n^2) a point.
std::shared_ptr<const CoordinateSystem> gradientMethod() {
  return std::make_shared<PointwiseSystem>(
      SystemDescription{.id = "gradient-method",
                        .name = "Gradient method",
                        .summary = "Maximises the smallest weight; positive, with kinks",
                        // The system jumps with 'highest'.
                        .traits = {.positive = true,
                                   .interpolates = true,
                                   .everywhere = false,
                                   .continuous = false,
                                   .smooth = false},
                        .parameters = {kStop, kGradientSeed}},
      [](const HandleSet& handles, const ParameterValues& parameters) {
        return std::make_unique<DirectionSolver>(handles.positions,
                                                 ascentOf<3>(handles.positions.rows(), parameters));
      });
}

} // namespace viscera::coordinates
