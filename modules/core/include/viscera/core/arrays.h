#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

/// Types for points, vectors and triangles that all modules use. Row major, so that VTK can use the same
/// memory without a copy.
namespace viscera {

/// One point or vector in mm, patient LPS (x to the left, y to the back, z to the head).
using Vec3 = Eigen::Vector3d;

/// `n x 3` points or vectors in mm, LPS, row major.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// `m x 3` vertex indices of triangles, counter-clockwise seen from outside, row major.
using Triangles = Eigen::Matrix<std::int32_t, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// `n x 3` colours, red green blue, 0 to 255, row major.
using Colors = Eigen::Matrix<std::uint8_t, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// `n` numbers.
using Values = Eigen::VectorXd;

/// Cubic millimetres in a millilitre.
inline constexpr double kMm3PerMl = 1000.0;

/// The corners of an axis-parallel box, mm.
struct Bounds {
  Vec3 low = Vec3::Zero();
  Vec3 high = Vec3::Zero();
  double diagonal() const { return (high - low).norm(); }
  Vec3 center() const { return 0.5 * (low + high); }
};

/// The bounding box of `n x 3` points; zero for no points. O(n).
inline Bounds boundsOf(const Points& points) {
  if (points.rows() == 0)
    return {};
  return {points.colwise().minCoeff().transpose(), points.colwise().maxCoeff().transpose()};
}

/// The points of a list as `n x 3`. O(n).
inline Points pointsOf(const std::vector<Vec3>& list) {
  Points points(static_cast<Eigen::Index>(list.size()), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    points.row(i) = list[static_cast<std::size_t>(i)].transpose();
  return points;
}

} // namespace viscera
