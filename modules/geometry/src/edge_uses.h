#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "viscera/core/arrays.h"

namespace viscera::geometry {

/// One use of an edge by a triangle, with its direction.
struct EdgeUse {
  std::uint64_t edge; ///< Its smaller vertex in the upper half, its larger one in the lower.
  std::int32_t side;  ///< 3 t + k for the edge from corner k of triangle t to the next one.
  bool forward;       ///< From the smaller vertex to the larger one.
};

/// Calls `visit` with a `std::span<const EdgeUse>` for every edge: its uses in the order of the triangles.
/// Edges ascend. O(m log m).
template <class Visit>
void forEachEdge(const Triangles& triangles, const Visit& visit) {
  std::vector<EdgeUse> uses;
  uses.reserve(static_cast<std::size_t>(triangles.size()));
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto a = std::uint64_t(triangles(t, k)), b = std::uint64_t(triangles(t, (k + 1) % 3));
      uses.push_back({std::min(a, b) << 32 | std::max(a, b), static_cast<std::int32_t>(3 * t + k), a < b});
    }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& x, const EdgeUse& y) {
    return std::pair(x.edge, x.side) < std::pair(y.edge, y.side);
  });
  for (auto begin = uses.cbegin(), end = begin; begin != uses.cend(); begin = end) {
    end = std::find_if(begin, uses.cend(), [&](const EdgeUse& use) { return use.edge != begin->edge; });
    visit(std::span(begin, end));
  }
}

} // namespace viscera::geometry
