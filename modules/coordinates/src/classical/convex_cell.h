#pragma once

#include <vector>

#include "viscera/core/arrays.h"

namespace viscera::coordinates {

/// A convex polyhedron around the origin that half spaces are cut from. What is close to a plane may fall on
/// either side of it: the volume changes by no more than rounding.
class ConvexCell {
public:
  /// The cube [-half, half]^3.
  explicit ConvexCell(double half);

  /// Keeps what has `normal . x <= offset`. True when anything was cut off. O(corners).
  bool cut(const Vec3& normal, double offset);

  bool empty() const { return faces_.size() < 4; }
  double volume() const;
  /// The largest coordinate of a corner, without sign.
  double reach() const;

private:
  using Face = std::vector<Vec3>;

  void close(std::vector<Vec3>& rim, const Vec3& normal);

  std::vector<Face> faces_; ///< Corners in order, counter-clockwise from outside.
};

} // namespace viscera::coordinates
