#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/core/parallel.h"
#include "viscera/strain/aha_segments.h"
#include "viscera/strain/heart_axes.h"

/// Thickness of the wall and twist of the ventricle.
namespace viscera::strain {

/// Where the thickness of each segment is measured: vertices of the left cavity. Immutable; thread-safe.
class ThicknessGauge {
public:
  /// Takes at most `most` vertices of the cavity's wall, evenly over it. `cap` marks triangles that are no
  /// wall. O(n).
  ThicknessGauge(const Points& rest, const Triangles& triangles, const std::vector<bool>& cap,
                 const HeartAxes& axes, int most = 1200);

  struct Bound {
    const Points* points = nullptr;
    const Triangles* triangles = nullptr;
    const std::vector<bool>* leftOut = nullptr; ///< Flags of triangles that are no wall; null: none.
  };
  /// The mean distance from the cavity's wall to the nearest place of the surfaces around the wall (the
  /// epicardium, the right cavity), mm; by segment, NaN for segments without vertices, of the cap too, where
  /// the nearest place is beside the tip. O((n + m) log m).
  std::array<double, kSegments + 1> at(const Points& cavity, const std::vector<Bound>& around,
                                       Threads threads = {}) const;

private:
  std::vector<std::pair<std::int32_t, int>> vertices_; ///< Row and segment.
};

/// Rings of the endocardium whose turns about the long axis are compared. Immutable; thread-safe.
class TwistGauge {
public:
  /// O(n).
  TwistGauge(const Points& rest, const std::vector<bool>& onWall, const HeartAxes& axes);

  bool complete() const { return base_.size() > kFewest && apex_.size() > kFewest; }

  struct Twist {
    double baseDegrees = 0; ///< Seen from the apex, anticlockwise positive.
    double apexDegrees = 0;
    double degrees() const { return apexDegrees - baseDegrees; }
  };
  /// The turns from `reference` to `now` about the long axis that fit the rings best, each about its own
  /// middle. O(n).
  Twist between(const Points& reference, const Points& now) const;
  /// Between the middles of both rings, mm.
  double distanceMm(const Points& points) const;

private:
  static constexpr std::size_t kFewest = 5;
  double turnOf(const std::vector<std::int32_t>& ring, const Points& reference, const Points& now) const;
  Vec3 middleOf(const std::vector<std::int32_t>& ring, const Points& points) const;

  Vec3 down_;
  std::vector<std::int32_t> base_, apex_;
};

/// Tells for each vertex whether it belongs to a triangle that `leftOut` does not mark. O(m).
std::vector<bool> verticesOf(Eigen::Index vertices, const Triangles& triangles,
                             const std::vector<bool>& leftOut);

} // namespace viscera::strain
