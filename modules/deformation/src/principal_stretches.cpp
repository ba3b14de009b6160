#include "viscera/deformation/principal_stretches.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>

#include <Eigen/Eigenvalues>

namespace viscera::deformation {
namespace {

constexpr int kHalvings = 24;

struct Nearest {
  int point = -1;
  double distance = std::numeric_limits<double>::infinity();
};

using Cells = std::unordered_map<std::int64_t, Nearest>;

/// The point nearest to the middle of each cell that holds some.
Cells cellsOf(const Points& points, Eigen::Index count, const Vec3& low, double edge) {
  Cells cells;
  constexpr std::int64_t kRow = std::int64_t{1} << 20;
  for (Eigen::Index i = 0; i < count; ++i) {
    const Vec3 at = (points.row(i).transpose() - low) / edge;
    const Vec3 cell = at.array().floor();
    const std::int64_t key =
        (static_cast<std::int64_t>(cell.z()) * kRow + static_cast<std::int64_t>(cell.y())) * kRow +
        static_cast<std::int64_t>(cell.x());
    Nearest& nearest = cells[key];
    const double distance = (at - cell - Vec3::Constant(0.5)).squaredNorm();
    if (distance < nearest.distance)
      nearest = {static_cast<int>(i), distance};
  }
  return cells;
}

} // namespace

PrincipalStretches principalStretches(const Eigen::Matrix3d& m) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(m * m.transpose());
  PrincipalStretches result;
  Eigen::Matrix3d axes = solver.eigenvectors().rowwise().reverse();
  if (axes.determinant() < 0)
    axes.col(2) = -axes.col(2);
  result.directions = Eigen::Quaterniond(axes).normalized();
  result.stretches = solver.eigenvalues().reverse().cwiseMax(0).cwiseSqrt();
  return result;
}

std::vector<int> thinnedPoints(const Points& points, Eigen::Index count, int most) {
  std::vector<int> chosen;
  if (count <= most) {
    for (Eigen::Index i = 0; i < count; ++i)
      chosen.push_back(static_cast<int>(i));
    return chosen;
  }
  const Bounds box = boundsOf(points.topRows(count));
  const double size = std::max((box.high - box.low).maxCoeff(), std::numeric_limits<double>::min());
  // The finest grid that has no more occupied cells than wanted, found by halving an interval of edges. Below
  // the lower end every point would be alone.
  double fine = size / (4 * std::cbrt(static_cast<double>(count)) + 4), coarse = 2 * size;
  Cells best = cellsOf(points, count, box.low, coarse);
  for (int i = 0; i < kHalvings && coarse / fine > 1.02; ++i) {
    const double edge = std::sqrt(fine * coarse);
    Cells cells = cellsOf(points, count, box.low, edge);
    if (static_cast<int>(cells.size()) <= most) {
      coarse = edge;
      best = std::move(cells);
    } else {
      fine = edge;
    }
  }
  for (const auto& [key, nearest] : best)
    chosen.push_back(nearest.point);
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

} // namespace viscera::deformation
