#pragma once

#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/strain/aha_segments.h"
#include "viscera/strain/heart_axes.h"

/// Strain of a surface whose points are followed, without any depth.
namespace viscera::strain {

/// The endocardium of a left ventricle by segments, for its strain along and around the long axis. Immutable;
/// thread-safe.
class EndocardialSegments {
public:
  /// `rest` (`n x 3`) are the points at rest; `cap` marks triangles that are no wall. O(m).
  EndocardialSegments(const Points& rest, const Triangles& triangles, const std::vector<bool>& cap,
                      const HeartAxes& axes);

  /// How many triangles a segment has, 1 to 17.
  int triangles(int segment) const { return counts_[static_cast<std::size_t>(segment)]; }

  /// The means of one phase against another, by the areas of the triangles in `reference`: engineering
  /// strain.
  struct Means {
    std::array<double, kSegments + 1> longitudinal{}, circumferential{}, area{}; ///< By number; 0: all.
  };
  Means between(const Points& reference, const Points& now) const;

private:
  struct Facet {
    std::array<std::int32_t, 3> corners{};
    int segment = 0;
    Eigen::Vector2d along, around; ///< The axes by the two edges from the first corner, at rest.
  };
  std::vector<Facet> facets_;
  std::array<int, kSegments + 1> counts_{};
};

/// The area of a surface in mm^2 without the triangles that `leftOut` marks (a flag each, or empty). O(m).
double areaWithout(const Points& points, const Triangles& triangles, const std::vector<bool>& leftOut);

} // namespace viscera::strain
