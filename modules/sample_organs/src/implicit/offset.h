#pragma once

#include "implicit/implicit_node.h"

namespace viscera::sample_organs {

/// The child grown (or, with a negative distance, shrunk) by `distance` mm.
class Offset final : public ImplicitNode {
public:
  Offset(NodePtr child, double distance);
  double distanceUpTo(const Vec3& point, double limit) const override {
    return child_->distanceUpTo(point, limit + offset_) - offset_;
  }

private:
  Shade shadeUnfinished(const Vec3& point) const override;

  NodePtr child_;
  double offset_;
};

} // namespace viscera::sample_organs
