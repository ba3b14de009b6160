#pragma once

#include <Eigen/Core>

#include "implicit/implicit_node.h"

namespace viscera::sample_organs {

/// An ellipsoid; its distance is the first-order one, exact on the surface and along the axes.
class Ellipsoid final : public ImplicitNode {
public:
  /// `axes` holds the directions of the semi-axes as columns, orthonormal; `radii` in mm, positive.
  Ellipsoid(const Vec3& center, const Vec3& radii, const Eigen::Matrix3d& axes);

  double distanceUpTo(const Vec3& point, double limit) const override;

private:
  Vec3 center_;
  Vec3 radii_;
  Eigen::Matrix3d toAxes_;
};

} // namespace viscera::sample_organs
