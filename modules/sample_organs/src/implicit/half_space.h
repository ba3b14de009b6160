#pragma once

#include "implicit/implicit_node.h"

namespace viscera::sample_organs {

/// All that lies behind a plane. Only useful inside an intersection or a subtraction.
class HalfSpace final : public ImplicitNode {
public:
  /// `normal` points out of the half space; any length but zero.
  HalfSpace(const Vec3& point, const Vec3& normal)
      : ImplicitNode(unlimited()), point_(point), normal_(normal.normalized()) {}

  double distanceUpTo(const Vec3& point, double /*limit*/) const override {
    return (point - point_).dot(normal_);
  }

private:
  /// A box that stands for "everywhere", small enough to be turned and scaled.
  static Extent unlimited() { return {Vec3::Constant(-1e6), Vec3::Constant(1e6)}; }

  Vec3 point_;
  Vec3 normal_;
};

} // namespace viscera::sample_organs
