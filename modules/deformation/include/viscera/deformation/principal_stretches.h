#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "viscera/core/arrays.h"

namespace viscera::deformation {

/// What a small ball of tissue becomes: an ellipsoid.
struct PrincipalStretches {
  Eigen::Quaterniond directions =
      Eigen::Quaterniond::Identity(); ///< Turns x, y, z into the ellipsoid's axes,
  Vec3 stretches = Vec3::Ones();      ///< which have grown by these, descending.
};

/// The left polar factor of the deformation gradient `m` (`M = V R`) by its axes: the directions are those in
/// the deformed body. Thread-safe.
PrincipalStretches principalStretches(const Eigen::Matrix3d& m);

/// At most `most` of the first `count` rows of `points`, spread evenly: one in each cell of a cubic grid, the
/// one nearest to the cell's middle. Ascending. The same points give the same answer. O(count).
std::vector<int> thinnedPoints(const Points& points, Eigen::Index count, int most);

} // namespace viscera::deformation
