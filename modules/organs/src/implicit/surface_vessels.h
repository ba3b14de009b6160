#pragma once

#include <vector>

#include "implicit/implicit_node.h"

namespace viscera::organs {

/// A body with vessels or fat on its surface, which melt into it over `blend` mm but keep a sharp change of
/// colour.
class SurfaceVessels final : public ImplicitNode {
public:
  SurfaceVessels(NodePtr base, std::vector<NodePtr> vessels, double blend);
  double distanceUpTo(const Vec3& point, double limit) const override;

private:
  Shade shadeUnfinished(const Vec3& point) const override;
  bool cannotMatter(const ImplicitNode& vessel, const Vec3& point, double distance) const;

  NodePtr base_;
  std::vector<NodePtr> vessels_;
  double blend_;
};

} // namespace viscera::organs
