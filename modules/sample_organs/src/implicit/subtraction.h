#pragma once

#include <vector>

#include "implicit/implicit_node.h"

namespace viscera::sample_organs {

/// What is inside `body` and outside all `cuts`, with rounded edges of `blend` mm. Looks like the body.
class Subtraction final : public ImplicitNode {
public:
  Subtraction(NodePtr body, std::vector<NodePtr> cuts, double blend);
  double distanceUpTo(const Vec3& point, double limit) const override;

private:
  Shade shadeUnfinished(const Vec3& point) const override;
  double cut(double distance, const Vec3& point) const;

  NodePtr body_;
  std::vector<NodePtr> cuts_;
  double blend_;
};

} // namespace viscera::sample_organs
