#pragma once

#include <vector>

#include "implicit/implicit_node.h"

namespace viscera::sample_organs {

/// What is inside all children, with rounded edges of `blend` mm. Looks like the first child.
class Intersection final : public ImplicitNode {
public:
  /// At least one child.
  Intersection(std::vector<NodePtr> children, double blend);
  double distanceUpTo(const Vec3& point, double limit) const override;

private:
  Shade shadeUnfinished(const Vec3& point) const override;
  double cut(double distance, const Vec3& point, double limit) const;

  std::vector<NodePtr> children_;
  double blend_;
};

} // namespace viscera::sample_organs
