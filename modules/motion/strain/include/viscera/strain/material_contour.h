#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/geometry/plane_cut.h"

/// Contours whose points are followed through the phases of a motion.
namespace viscera::strain {

/// A polyline of places on the edges of a surface. Each place is `(1 - part) * from + part * to` of two
/// vertices, so that it is the same material place in every phase. Immutable.
struct MaterialContour {
  struct Place {
    std::int32_t from = 0, to = 0; ///< Rows of the surface's points; equal for a vertex itself.
    double part = 0;
  };
  std::vector<Place> places;
  bool closed = false;

  /// A contour through vertices in that order.
  static MaterialContour through(const std::vector<std::int32_t>& vertices, bool closed);

  /// The contour's places at `points` (those of the surface in a phase), `k x 3`. O(k).
  Points at(const Points& points) const;
  /// The contour's length there, mm. O(k).
  double lengthAt(const Points& points) const;
};

/// The lines in which a plane cuts a surface, as material contours. Triangles that `leftOut` marks (a flag
/// each, or empty) are no part of the surface, so that a contour over the apex ends at the rim of a valve.
/// Longest first. O(m + k log k).
std::vector<MaterialContour> cutContours(const Points& points, const Triangles& triangles,
                                         const std::vector<bool>& leftOut, const geometry::Plane& plane);

/// The part of an open contour from `place` on to its end, or up to it.
MaterialContour partFrom(const MaterialContour& contour, std::size_t place);
MaterialContour partUpTo(const MaterialContour& contour, std::size_t place);

} // namespace viscera::strain
