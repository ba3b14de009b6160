#pragma once

#include <vector>

#include "implicit/implicit_node.h"

namespace viscera::sample_organs {

/// Everything inside any of the children, with fillets of `blend` mm where they meet. Colours mix across the
/// seams.
class Union final : public ImplicitNode {
public:
  /// At least one child.
  Union(std::vector<NodePtr> children, double blend);
  double distanceUpTo(const Vec3& point, double limit) const override;

private:
  Shade shadeUnfinished(const Vec3& point) const override;
  bool cannotMatter(const ImplicitNode& child, const Vec3& point, double distance) const;

  std::vector<NodePtr> children_;
  double blend_;
};

} // namespace viscera::sample_organs
