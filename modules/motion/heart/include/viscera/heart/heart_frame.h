#pragma once

#include "viscera/core/arrays.h"

namespace viscera::heart {

/// A point in the cylindrical coordinates of a heart's ventricular frame.
struct HeartPoint {
  double rho = 0; ///< Distance from the long axis, mm.
  double phi = 0; ///< Angle around it, rad: 0 towards the right ventricle, pi/2 inferior.
  double c = 0;   ///< Along it, mm: 0 at the mitral valve, growing towards the apex.
};

/// The coordinate frame of a heart's ventricles: origin at the middle of the mitral valve, axes towards the
/// right ventricle (a), the diaphragm (b) and the apex (c), right-handed and orthonormal. Immutable;
/// thread-safe.
class HeartFrame {
public:
  /// The axes of the world.
  HeartFrame() = default;

  /// `towardsRight` need only be approximate: its component along `towardsApex` is removed. Throws
  /// `DataError` when the two directions are parallel or not finite.
  HeartFrame(const Vec3& origin, const Vec3& towardsRight, const Vec3& towardsApex);

  /// World (mm, LPS) to (a, b, c).
  Vec3 toLocal(const Vec3& point) const { return axes_.transpose() * (point - origin_); }
  Vec3 toWorld(const Vec3& local) const { return axes_ * local + origin_; }
  HeartPoint cylindrical(const Vec3& point) const;
  Vec3 toWorld(const HeartPoint& point) const;

  const Vec3& origin() const { return origin_; }
  /// The unit vector towards the right ventricle.
  Vec3 towardsRight() const { return axes_.col(0); }
  /// The unit vector from base to apex.
  Vec3 towardsApex() const { return axes_.col(2); }

private:
  Vec3 origin_ = Vec3::Zero();
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity(); ///< Columns a, b, c.
};

/// The frame of the sample heart, in which its definition places the ventricles.
HeartFrame sampleHeartFrame();

} // namespace viscera::heart
