#include "viscera/coordinates/measure/newton_spread.h"

#include <algorithm>
#include <deque>
#include <optional>
#include <utility>

#include <Eigen/LU>

namespace viscera::coordinates {
namespace {

/// The T-Celestial equations at one point.
class Equations {
public:
  Equations(const Points& handles, const Vec3& point)
      : units_((handles.rowwise() - point.transpose()).rowwise().normalized()) {}

  /// sum exp(psi . q_i) q_i
  Vec3 value(const Vec3& psi) const { return units_.transpose() * (units_ * psi).array().exp().matrix(); }

  /// sum exp(psi . q_i) q_i q_i^T
  Eigen::Matrix3d derivative(const Vec3& psi) const {
    const Values grown = (units_ * psi).array().exp();
    return units_.transpose() * grown.asDiagonal() * units_;
  }

  /// The solution of the equations with 1 + t for exp(t): sum (1 + psi . q_i) q_i = 0, which is
  /// (sum q_i q_i^T) psi = -sum q_i.
  Vec3 linearised() const {
    const Eigen::Matrix3d matrix = units_.transpose() * units_;
    const Vec3 sum = units_.colwise().sum().transpose();
    return -matrix.partialPivLu().solve(sum);
  }

private:
  Points units_;
};

struct Solved {
  Vec3 psi;
  int iterations;
};

std::optional<Solved> newton(const Equations& equations, Vec3 psi, const NewtonSpreadOptions& options) {
  for (int iteration = 0; iteration <= options.mostIterations; ++iteration) {
    const Vec3 value = equations.value(psi);
    if (!value.allFinite())
      return std::nullopt;
    if (value.norm() <= options.tolerance)
      return Solved{psi, iteration};
    psi -= equations.derivative(psi).partialPivLu().solve(value);
  }
  return std::nullopt;
}

class Spreader {
public:
  Spreader(const Points& handles, const Points& points, NeighbourOrder order,
           const NewtonSpreadOptions& options)
      : handles_(handles), points_(points), order_(order), options_(options),
        middle_(handles.colwise().mean()), solution_(static_cast<std::size_t>(points.rows())),
        seen_(static_cast<std::size_t>(points.rows())) {}

  NewtonSpread run(Progress& progress) {
    for (Eigen::Index point = 0; point < points_.rows(); ++point) {
      if (!seen_[static_cast<std::size_t>(point)] && seed(point))
        spread(progress);
    }
    NewtonSpread result = std::move(result_);
    if (const Eigen::Index solved = sum(result.solvedBy); solved > 0)
      result.meanIterations = static_cast<double>(iterations_) / static_cast<double>(solved);
    result.unsolved = points_.rows() - result.seeds - sum(result.solvedBy);
    return result;
  }

private:
  using Row = Eigen::Index;

  static Eigen::Index sum(const std::vector<Eigen::Index>& counts) {
    Eigen::Index all = 0;
    for (const Eigen::Index count : counts)
      all += count;
    return all;
  }

  Equations at(Row point) const { return {handles_, points_.row(point).transpose()}; }

  bool seed(Row point) {
    const Equations equations = at(point);
    const auto solved = newton(equations, equations.linearised(), options_);
    if (!solved)
      return false;
    seen_[static_cast<std::size_t>(point)] = true;
    solution_[static_cast<std::size_t>(point)] = solved->psi;
    ++result_.seeds;
    enqueueAround(point);
    return true;
  }

  void spread(Progress& progress) {
    while (!queue_.empty()) {
      progress.throwIfCancelled();
      const Row point = queue_.front();
      queue_.pop_front();
      if (solve(point))
        enqueueAround(point);
    }
  }

  /// The neighbours of a point, the nearest first.
  std::vector<Row> around(Row point) const {
    std::vector<std::pair<double, Row>> found;
    for (Row other = 0; other < points_.rows(); ++other) {
      const double distance = (points_.row(other) - points_.row(point)).norm();
      if (other != point && distance < options_.radius)
        found.emplace_back(distance, other);
    }
    return sorted(std::move(found));
  }

  static std::vector<Row> sorted(std::vector<std::pair<double, Row>> keyed) {
    std::sort(keyed.begin(), keyed.end());
    std::vector<Row> rows;
    for (const auto& [key, row] : keyed)
      rows.push_back(row);
    return rows;
  }

  void enqueueAround(Row point) {
    for (const Row other : around(point))
      if (!seen_[static_cast<std::size_t>(other)]) {
        seen_[static_cast<std::size_t>(other)] = true;
        queue_.push_back(other);
      }
  }

  /// The neighbours that have a solution, in the order in which they are tried.
  std::vector<Row> triedAround(Row point, const Equations& equations) const {
    std::vector<Row> solved = around(point);
    std::erase_if(solved, [&](Row other) { return !solution_[static_cast<std::size_t>(other)]; });
    if (order_ == NeighbourOrder::euclidean)
      return solved;
    std::vector<std::pair<double, Row>> keyed;
    const Vec3 place = (points_.row(point) - middle_).transpose();
    for (const Row other : solved)
      keyed.emplace_back((equations.derivative(*solution_[static_cast<std::size_t>(other)]) * place).norm(),
                         other);
    return sorted(std::move(keyed));
  }

  bool solve(Row point) {
    const Equations equations = at(point);
    const std::vector<Row> tried = triedAround(point, equations);
    for (std::size_t number = 0; number < tried.size(); ++number) {
      const auto solved = newton(equations, *solution_[static_cast<std::size_t>(tried[number])], options_);
      if (!solved)
        continue;
      solution_[static_cast<std::size_t>(point)] = solved->psi;
      iterations_ += solved->iterations;
      if (result_.solvedBy.size() <= number)
        result_.solvedBy.resize(number + 1);
      ++result_.solvedBy[number];
      return true;
    }
    return false;
  }

  const Points& handles_;
  const Points& points_;
  NeighbourOrder order_;
  NewtonSpreadOptions options_;
  Eigen::RowVector3d middle_;
  std::vector<std::optional<Vec3>> solution_;
  std::vector<char> seen_; ///< Solved, or in the queue, or given up.
  std::deque<Row> queue_;
  NewtonSpread result_;
  long iterations_ = 0;
};

} // namespace

double NewtonSpread::shareByFirst() const {
  Eigen::Index all = 0;
  for (const Eigen::Index count : solvedBy)
    all += count;
  return all > 0 ? static_cast<double>(solvedBy.front()) / static_cast<double>(all) : 0;
}

NewtonSpread spreadNewton(const Points& handles, const Points& points, NeighbourOrder order,
                          const NewtonSpreadOptions& options, Progress& progress) {
  return Spreader(handles, points, order, options).run(progress);
}

} // namespace viscera::coordinates
