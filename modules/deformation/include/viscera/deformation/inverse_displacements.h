#pragma once

#include "viscera/coordinates/coordinate_system.h"
#include "viscera/core/progress.h"

namespace viscera::deformation {

/// A displacement field: a vector at every point of a regular, axis-parallel grid.
struct DisplacementGrid {
  Eigen::Vector3i size = Eigen::Vector3i::Zero(); ///< Points along x, y, z; two at least.
  Vec3 origin = Vec3::Zero();                     ///< The first point, mm, LPS.
  double spacing = 1;                             ///< mm, along each axis.
  Points vectors;                                 ///< `size.prod() x 3`, mm; x runs fastest.
  double largestErrorMm = 0;                      ///< Of the points that were reached.
  Eigen::Index unreached = 0; ///< Points without an answer, because tissue is folded or has no coordinates.

  Vec3 point(Eigen::Index row) const;
};

/// The box and the spacing of a displacement grid.
struct GridOptions {
  Bounds box;         ///< mm.
  double spacing = 5; ///< mm.
};

/// The box around a surface at rest and posed, with two cells of room.
GridOptions gridAround(const Points& rest, const Points& posed, double spacing);

/// The largest number of points of a grid.
inline constexpr double kMostGridPoints = 2e7;

/// Computes where the tissue at the points of a grid was at rest: for a pose that moves a rest point p to
/// F(p), the vector d at x solves F(x + d) = x. That is the direction in which images are resampled and in
/// which 3D Slicer and ITK keep displacement fields in files.
///
/// F is the deformation by the system's coordinates when the handles move from `handles.positions` to `pose`
/// (`n x 3`). Outside the handles' hull, where there are no coordinates, a point moves as the one does where
/// the line to the hull's middle enters the hull, so that the field is continuous there. Each point is found
/// by Broyden's iteration (Broyden 1965, doi 10.1090/S0025-5718-1965-0198670-6) to a thousandth of the
/// spacing.
///
/// Throws what binding throws, `UsageError` for a spacing that is not positive or more than
/// `kMostGridPoints`, `Cancelled`. About ten bindings of the grid's points.
DisplacementGrid inverseDisplacements(const coordinates::CoordinateSystem& system,
                                      const coordinates::HandleSet& handles, const Points& pose,
                                      const coordinates::BindOptions& options, const GridOptions& grid,
                                      Progress& progress);

} // namespace viscera::deformation
