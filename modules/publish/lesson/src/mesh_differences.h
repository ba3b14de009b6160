#pragma once

#include <cstdint>
#include <vector>

#include "viscera/core/arrays.h"

/// What a number of a vertex is off its neighbours'. Fields over a surface are smooth across it, not along
/// the order of its vertices: what is left here deflates to half of differences to the vertex before.
namespace viscera::lesson {

class MeshDifferences {
public:
  /// `triangles` over vertices from 0 to below `vertices`, of which some may have no triangle.
  MeshDifferences(const Triangles& triangles, Eigen::Index vertices);

  /// `values` are fields one behind the other, each `vertices x components`. From each number its guess is
  /// taken: the rounded mean of the same number at the vertices before this one that share a triangle with
  /// it, each as often as they do; without such that of the vertex before, 0 for the first one. Modulo 2^32.
  /// O(values).
  std::vector<std::int32_t> of(const std::vector<std::int32_t>& values, int components) const;
  /// The values whose differences are these, as the page finds them.
  std::vector<std::int32_t> undone(const std::vector<std::int32_t>& differences, int components) const;

private:
  std::int32_t guess(const std::int32_t* field, std::size_t vertex, std::size_t components) const;

  std::vector<std::size_t> first_; ///< Of each vertex, in `before_`; one more at the end.
  std::vector<std::size_t> before_;
};

} // namespace viscera::lesson
