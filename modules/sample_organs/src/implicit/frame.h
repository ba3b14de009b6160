#pragma once

#include <Eigen/Core>

#include "implicit/implicit_node.h"

namespace viscera::sample_organs {

/// Where a child's own frame lies: `world = origin + rotation * scale * mirror * local`.
struct Placement {
  Vec3 origin = Vec3::Zero();
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Vec3 mirror = Vec3::Ones(); ///< 1 or -1 along each local axis.
  double scale = 1;
};

/// The child placed in its own frame.
class Frame final : public ImplicitNode {
public:
  Frame(NodePtr child, const Placement& placement);
  double distanceUpTo(const Vec3& point, double limit) const override;

private:
  Shade shadeUnfinished(const Vec3& point) const override;
  Vec3 local(const Vec3& point) const;

  NodePtr child_;
  Placement placement_;
};

} // namespace viscera::sample_organs
