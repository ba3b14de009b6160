#pragma once

#include <algorithm>
#include <cmath>

#include "viscera/coordinates/coordinate_system.h"

/// Compares closed-form derivatives of coordinates with differences of the coordinates.
namespace viscera::tests {

/// The result of the comparison.
struct GradientCheck {
  double worst = 0; ///< Largest error at a point by the size of its gradients.
  int unsure = 0;   ///< Points where differences of two steps disagree by more than the tolerance: at a seam.
};

/// Fourth-order central differences of `steps[i]` and half of it at point i, mm.
inline GradientCheck checkGradients(const coordinates::CoordinateSystem& system,
                                    const coordinates::HandleSet& handles, const Points& points,
                                    const Values& steps, const coordinates::BindOptions& options,
                                    double tolerance) {
  constexpr int kMoves = 24; // 3 axes, 2 steps, 4 places.
  constexpr double kPlace[4] = {-2, -1, 1, 2}, kWeight[4] = {1.0 / 12, -8.0 / 12, 8.0 / 12, -1.0 / 12};
  Points moved(kMoves * points.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    for (int move = 0; move < kMoves; ++move) {
      auto row = moved.row(kMoves * i + move);
      row = points.row(i);
      row[move / 8] += kPlace[move % 4] * steps[i] / (move / 4 % 2 == 0 ? 1 : 2);
    }
  Progress progress;
  const auto binding = system.bind(handles, moved, options, progress);
  const auto exact = system.gradients(handles, points, options, progress);
  const Eigen::Index count = binding->handleCount();
  Points whole = Points::Zero(points.rows() * count, 3), half = whole;
  for (Eigen::Index h = 0; h < count; ++h) {
    const Values a = binding->influence(static_cast<int>(h));
    for (Eigen::Index i = 0; i < points.rows(); ++i)
      for (int move = 0; move < kMoves; ++move) {
        const bool halved = move / 4 % 2 == 1;
        (halved ? half : whole)(i * count + h, move / 8) +=
            kWeight[move % 4] * a[kMoves * i + move] / (halved ? steps[i] / 2 : steps[i]);
      }
  }
  GradientCheck result;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Points rows = exact.values.middleRows(i * count, count);
    const double size = rows.norm();
    if ((whole - half).middleRows(i * count, count).norm() > tolerance * size)
      ++result.unsure;
    else
      result.worst = std::max(result.worst, (rows - half.middleRows(i * count, count)).norm() / size);
  }
  return result;
}

} // namespace viscera::tests
