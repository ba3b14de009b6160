#pragma once

#include <string>
#include <vector>

#include "viscera/coordinates/handle_set.h"
#include "viscera/core/arrays.h"

/// Divides handles into groups automatically, for localised coordinates; a user edits them afterwards. Every
/// group's hull holds its part of the organ, so that no vertex lies in no region; if the given handles do not
/// suffice, eight corners of a box around the part are added. All functions are deterministic.
namespace viscera::deformation {

/// The groups that were made, over the given handles followed by the handles `added`: row i of `added` is
/// handle `given + i`.
struct Grouping {
  Points added; ///< `m x 3` mm, may be empty.
  std::vector<coordinates::HandleGroup> groups;
};

/// Splits the handles along the organ's longest axis into `count` parts; neighbours share a stretch of
/// `overlap` (0 to 1) of a part's length at least: the faces between them go into gaps between handles, so
/// that a generous offset remains. Boxes lie along the organ's principal axes and are equally wide, so that
/// only neighbours meet. Handles are `n x 3`, `organPoints` `v x 3`. Throws `UsageError` for a count below 1
/// or an overlap out of range, `DataError` for no points. O(v + n).
Grouping groupsAlongAxis(const Points& handles, const Points& organPoints, int count, double overlap = 0.25);

/// Clusters the organ into `count` parts by nearness (k-means of its points from farthest-point seeds, so
/// that no group is without a part of the organ) and gives each the handles nearest to its middle; a handle
/// about as near to a second cluster as to its own belongs to both, and so does one less than a hundredth of
/// the organ's diagonal outside a group's hull, so that at least such an offset remains. Throws as above, and
/// `DataError` for fewer handles, or fewer points, than groups.
Grouping groupsByCluster(const Points& handles, const Points& organPoints, int count);

/// Makes one group for each organ: the handles nearer to it than to any other. Throws `DataError` for an
/// organ without points.
Grouping groupsByOrgan(const Points& handles, const std::vector<Points>& organs,
                       const std::vector<std::string>& names);

} // namespace viscera::deformation
