#include "viscera/coordinates/measure/profile_measures.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace viscera::coordinates {

double roughness(const Eigen::MatrixXd& coordinates) {
  double squares = 0;
  int counted = 0;
  for (Eigen::Index row = 1; row + 1 < coordinates.rows(); ++row) {
    const double bend =
        (coordinates.row(row + 1) - 2 * coordinates.row(row) + coordinates.row(row - 1)).squaredNorm();
    squares += std::isfinite(bend) ? bend : 0;
    counted += std::isfinite(bend) ? 1 : 0;
  }
  return std::sqrt(squares / counted);
}

double nearHalfShare(const Points& handles, const Points& points, const Eigen::MatrixXd& coordinates) {
  double sum = 0;
  int counted = 0;
  std::vector<Eigen::Index> order(static_cast<std::size_t>(handles.rows()));
  for (Eigen::Index point = 0; point < points.rows(); ++point) {
    const double all = coordinates.row(point).cwiseAbs().sum();
    if (!(all > 0))
      continue;
    const Values distances = (handles.rowwise() - points.row(point)).rowwise().norm();
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](Eigen::Index a, Eigen::Index b) { return distances[a] < distances[b]; });
    double near = 0;
    for (std::size_t i = 0; i < order.size() / 2; ++i)
      near += std::abs(coordinates(point, order[i]));
    sum += near / all;
    ++counted;
  }
  return counted > 0 ? sum / counted : 0;
}

} // namespace viscera::coordinates
