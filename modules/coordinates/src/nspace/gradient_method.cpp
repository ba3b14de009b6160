#include "viscera/coordinates/nspace/gradient_method.h"

#include <algorithm>
#include <limits>
#include <random>
#include <utility>

#include <Eigen/LU>

#include "choice_parameter.h"
#include "nspace/direction_solver.h"

namespace viscera::coordinates {
namespace {

enum class Stop { inside, highest };

const Parameter kStop =
    choiceParameter("stop", "When the ascent of the smallest number ends", {"inside", "highest"});
const Parameter kSeed =
    countParameter("seed", "0 starts from all ones, others from random numbers", 0, 1e6, 1);

/// Of one: slower than this the smallest number does not rise.
constexpr double kStill = 1e-12;

/// Where a balanced vector goes when its tied numbers are raised together, staying balanced and tied.
class Ascent {
public:
  Ascent(const Points& units, Values start) : units_(units), values_(std::move(start)) {
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
    Eigen::Matrix3d outer = Eigen::Matrix3d::Zero();
    Vec3 sum = Vec3::Zero();
    double count = 0;
    for (Eigen::Index i = 0; i < values_.size(); ++i) {
      const Vec3 unit = units_.row(i).transpose();
      if (tied(i)) {
        sum += unit;
        ++count;
      } else {
        outer += unit * unit.transpose();
      }
    }
    outer += sum * sum.transpose() / count;
    Eigen::Matrix3d inverse;
    double determinant = 0;
    bool invertible = false;
    outer.computeInverseAndDetWithCheck(inverse, determinant, invertible, kStill);
    if (!invertible)
      return false;
    const Vec3 pull = inverse * sum;
    direction_ = -units_ * pull;
    const double together = 1 - sum.dot(pull) / count;
    for (Eigen::Index i = 0; i < values_.size(); ++i)
      if (tied(i))
        direction_[i] = together;
    return together > kStill;
  }

  /// How far to the next tie, and with whom; -1 when there is none.
  std::pair<double, Eigen::Index> nextTie() const {
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
  bool tied(Eigen::Index i) const { return tied_[static_cast<std::size_t>(i)]; }

  const Points& units_;
  Values values_;
  Values direction_;
  std::vector<bool> tied_;
  Eigen::Index last_ = 0; ///< One of the tied.
};

class Solver final : public DirectionSolver {
public:
  Solver(const Points& handles, Stop stop, unsigned seed)
      : DirectionSolver(handles), stop_(stop), start_(Values::Ones(handles.rows())) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(0, 1);
    for (Eigen::Index i = 0; seed != 0 && i < start_.size(); ++i)
      start_[i] = number(random);
  }

private:
  bool balance(const Sight& sight, Values& beta) const override {
    const BalancedSpace space(sight.units);
    if (!space.valid())
      return false;
    Ascent ascent(sight.units, space.project(start_));
    while ((stop_ == Stop::highest || ascent.smallest() < 0) && ascent.findDirection()) {
      const auto [distance, handle] = ascent.nextTie();
      const double toZero = -ascent.smallest() / ascent.rate();
      if (stop_ == Stop::inside && toZero <= distance) {
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

  Stop stop_;
  Values start_;
};

} // namespace

std::string GradientMethod::summary() const {
  return "The smallest number is raised as high as it goes; positive, with kinks";
}

Traits GradientMethod::traits() const {
  Traits traits;
  traits.positive = true;
  traits.interpolates = true;
  traits.everywhere = false;
  traits.continuous = false; // With 'highest'.
  traits.smooth = false;
  return traits;
}

std::vector<Parameter> GradientMethod::parameters() const {
  return {kStop, kSeed};
}

std::unique_ptr<const PointSolver> GradientMethod::prepare(const HandleSet& handles,
                                                           const ParameterValues& parameters) const {
  return std::make_unique<Solver>(handles.positions, chosen<Stop>(parameters, kStop),
                                  static_cast<unsigned>(parameters.get(kSeed)));
}

} // namespace viscera::coordinates
