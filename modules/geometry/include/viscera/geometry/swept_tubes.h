#pragma once

#include <vector>

#include "viscera/core/arrays.h"

namespace viscera::geometry {

/// Tubes around lines that move, as one mesh: each tube is a closed surface with blunt ends, outward, and its
/// cross-sections stay circles however the lines bend. Immutable; thread-safe.
class SweptTubes {
public:
  static constexpr int kSides = 10;

  /// How many points each line has, two at least, and the radius at each of all points, mm. Throws
  /// `UsageError` when these do not go together.
  SweptTubes(std::vector<Eigen::Index> lines, Values radii);

  const Triangles& triangles() const { return triangles_; }
  Eigen::Index points() const { return points_; } ///< Of the mesh.
  /// Writes the mesh's points for these points of the lines, one line after the other. Throws `UsageError`
  /// for another number of points. O(n).
  void at(const Points& lines, Points& out) const;

private:
  std::vector<Eigen::Index> lines_;
  Values radii_;
  Triangles triangles_;
  Eigen::Index points_ = 0;
};

} // namespace viscera::geometry
