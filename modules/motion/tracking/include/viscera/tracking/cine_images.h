#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "viscera/core/arrays.h"

/// The images of a cine study as numbers: single planes through a beating organ, each over one cycle.
namespace viscera::tracking {

/// The grey values of one image, rows x columns.
using CineImage = Eigen::Array<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A plane of a cine study, and what it shows over a cycle. mm, LPS.
///
///     CinePlane plane;
///     plane.name = "four chambers";
///     plane.origin = Vec3(-120, -80, 40);
///     plane.alongRow = Vec3::UnitX();
///     plane.alongColumn = Vec3::UnitY();
///     plane.spacing = Eigen::Vector2d(1.4, 1.4);
///     for (int phase = 0; phase < 20; ++phase) {
///       plane.fractions.push_back(phase / 20.0);
///       plane.images.push_back(CineImage::Zero(160, 192));
///     }
struct CinePlane {
  std::string name;
  Vec3 origin = Vec3::Zero();                               ///< The centre of the first pixel.
  Vec3 alongRow = Vec3::UnitX();                            ///< Unit; the way in which column numbers grow.
  Vec3 alongColumn = Vec3::UnitY();                         ///< Unit; the way in which row numbers grow.
  Eigen::Vector2d spacing = Eigen::Vector2d::Constant(1.0); ///< Between columns, and rows, mm.
  /// When each image was taken: the part of the plane's own interval, in [0, 1), ascending. Planes are taken
  /// in different breath-holds with intervals that differ, so that only parts compare.
  std::vector<double> fractions;
  std::vector<CineImage> images; ///< One for each of them, all of one size.

  Vec3 normal() const { return alongRow.cross(alongColumn); }
  /// mm from the plane, positive on the side of its normal.
  double aside(const Vec3& point) const { return (point - origin).dot(normal()); }
  /// The image nearest to a part of the cycle, round its end; -1 where none is within `tolerance` of it: an
  /// image that is missing or damaged.
  int imageAt(double fraction, double tolerance) const;
};

/// Throws `DataError` that names the first plane whose directions are no perpendicular unit vectors, whose
/// spacing is not positive, whose fractions do not ascend in [0, 1), or whose images have different sizes or
/// numbers that are not finite. O(pixels).
void requireValid(const std::vector<CinePlane>& planes);

/// Tells which planes are long-axis ones: all but the largest number of planes that are parallel to within 10
/// degrees. All of them where no two are parallel. O(planes^2).
std::vector<bool> longAxisPlanes(const std::vector<CinePlane>& planes);

} // namespace viscera::tracking
