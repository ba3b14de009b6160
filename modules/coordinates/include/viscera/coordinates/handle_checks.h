#pragma once

#include <Eigen/Core>

/// Checks handles before coordinates are computed with them.
namespace viscera::coordinates {

/// The type of `n x Dim` points in two or three dimensions, row major; with Dim = 3 the same as `Points`.
template <int Dim>
using PointsOf = Eigen::Matrix<double, Eigen::Dynamic, Dim, Eigen::RowMajor>;

/// Throws `DataError` for handles that no point could be bound to: fewer than Dim + 1, not finite, two at one
/// place, or all in one plane (one line for Dim = 2), each to 1e-9 of their size. The message names the
/// handles, counted from 0. Defined for Dim = 2 and 3. O(n^2).
template <int Dim>
void requireUsableHandles(const PointsOf<Dim>& handles);

} // namespace viscera::coordinates
