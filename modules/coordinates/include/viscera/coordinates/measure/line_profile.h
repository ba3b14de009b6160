#pragma once

#include "viscera/coordinates/coordinate_system.h"

namespace viscera::coordinates {

/// A line of sample points, straight or curved like a parabola, mm.
struct Line {
  Vec3 from;
  Vec3 to;
  Vec3 sag = Vec3::Zero(); ///< How far the middle lies off the straight line.

  /// The point at `place`, 0 to 1.
  Vec3 at(double place) const { return (1 - place) * from + place * to + 4 * place * (1 - place) * sag; }
};

/// The coordinates along a line: `parts + 1` points from end to end.
struct LineProfile {
  Eigen::MatrixXd coordinates; ///< `points x handles`; rows of points without an answer are zero.
  BindingReport report;
};

/// Jumps, kinks and local maxima of a system's coordinates along a line.
struct LineProperties {
  BindingReport report;   ///< Of the points of the profile.
  double largestJump = 0; ///< Of a coordinate between two points whose distance goes to zero.
  int kinks = 0;          ///< Places where the derivative of a coordinate jumps.
  double largestKink = 0; ///< The largest of those jumps, 1/mm.
  int localMaxima = 0;    ///< The most that any handle's coordinate has along the line, ends included.
};

/// Binds `parts + 1` points of the line. Throws as `CoordinateSystem::bind`.
LineProfile profileAlong(const CoordinateSystem& system, const HandleSet& handles, const Line& line,
                         int parts, const BindOptions& options, Progress& progress);

/// Measures jumps and kinks by sampling ever finer where the coordinates, or their slopes, change most: the
/// change of a smooth function goes to zero with the distance, a jump stays. Gaps (points without an answer)
/// are counted in the report and are no jumps. About ten bindings of `parts` points. Throws as
/// `CoordinateSystem::bind`.
LineProperties measureAlong(const CoordinateSystem& system, const HandleSet& handles, const Line& line,
                            int parts, const BindOptions& options, Progress& progress);

/// The coordinates of a binding's points, `points x handles`; rows of points without any are not numbers.
Eigen::MatrixXd coordinatesOf(const Binding& binding);

/// The root mean square of the second differences from row to row: noise is large here, a smooth curve is
/// not. Rows that are not numbers are passed over; not a number where no three rows in a row are.
double roughness(const Eigen::MatrixXd& coordinates);

/// The share of the nearer half of the handles in all influence, by absolute values, as the mean over the
/// points: 1 for a very local system, 1/2 for one that does not depend on distances. Rows without coordinates
/// (zeros) do not count.
double nearHalfShare(const Points& handles, const Points& points, const Eigen::MatrixXd& coordinates);

} // namespace viscera::coordinates
