#pragma once

#include <algorithm>
#include <cstdint>

#include "viscera/core/arrays.h"

/// Solids of tetrahedra with known properties, for tests.
namespace viscera::tests {

struct Solid {
  Points points;
  Eigen::Matrix<std::int32_t, Eigen::Dynamic, 4, Eigen::RowMajor> tetrahedra; ///< Positive.
};

/// The box of half side `half` around the origin, cut into `n^3` cubes of six tetrahedra each.
inline Solid solidBox(int n, double half) {
  Solid solid;
  const int side = n + 1;
  solid.points.resize(side * side * side, 3);
  const auto index = [side](int x, int y, int z) { return (z * side + y) * side + x; };
  for (int z = 0; z < side; ++z)
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x)
        solid.points.row(index(x, y, z)) << 2.0 * x / n - 1, 2.0 * y / n - 1, 2.0 * z / n - 1;
  solid.points *= half;
  solid.tetrahedra.resize(6 * n * n * n, 4);
  Eigen::Index row = 0;
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        // One tetrahedron for every order of the axes along the way from the lowest corner to the highest.
        int order[3] = {0, 1, 2};
        do {
          int at[3] = {x, y, z};
          std::int32_t corners[4] = {index(x, y, z), 0, 0, 0};
          for (int step = 0; step < 3; ++step) {
            ++at[order[step]];
            corners[step + 1] = index(at[0], at[1], at[2]);
          }
          const bool even = (order[1] - order[0] + 3) % 3 == 1;
          if (!even)
            std::swap(corners[1], corners[2]);
          solid.tetrahedra.row(row++) << corners[0], corners[1], corners[2], corners[3];
        } while (std::next_permutation(order, order + 3));
      }
  return solid;
}

} // namespace viscera::tests
