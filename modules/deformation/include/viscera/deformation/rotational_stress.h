#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "viscera/core/arrays.h"

namespace viscera::deformation {

/// The distortion of the tissue at one point by a deformation (thesis 5.2): angle and stretches.
struct LocalDistortion {
  /// Local rotational stress: the largest angle between a direction and its image under the stretch, rad,
  /// 0 to pi/2. It is an angle and a measure of distortion, not a mechanical stress.
  double rotationalStress = 0;
  double volumeRatio = 1; ///< det M: the local change of volume; at most 0 where the tissue is folded.
  double stretchMax = 1;  ///< The largest singular value: how much the most stretched direction grows.
  double stretchMin = 1;  ///< The smallest.
  bool folded() const { return volumeRatio <= 0; }
};

/// The distortion by the deformation gradient `m`. With the singular values s1 >= s2 >= s3 the largest angle
/// is `arcsin((s1 - s3) / (s1 + s3))`: the middle value plays no part. (The thesis approximates the angle by
/// a polynomial of degree six; this is exact.) Zero for a rigid motion, for a uniform scaling, and for m = 0,
/// where no direction has an image. Closed form, about 100 ns; thread-safe.
LocalDistortion localDistortion(const Eigen::Matrix3d& m);

/// The singular values of `m`, descending, in closed form.
Eigen::Vector3d singularValues(const Eigen::Matrix3d& m);

/// The ellipsoid that a deformation makes of a small ball of tissue, by its axes and their lengths.
struct PrincipalStretches {
  Eigen::Quaterniond directions =
      Eigen::Quaterniond::Identity(); ///< Turns x, y, z into the ellipsoid's axes,
  Vec3 stretches = Vec3::Ones();      ///< which have grown by these, descending.
};

/// The left polar factor of the deformation gradient `m` (`M = V R`) by its axes: the directions are those in
/// the deformed body. Thread-safe.
PrincipalStretches principalStretches(const Eigen::Matrix3d& m);

} // namespace viscera::deformation
