#pragma once

#include <vector>

#include "implicit/implicit_node.h"

namespace viscera::sample_organs {

/// A tube on the surface of a body.
struct SurfaceVessel {
  NodePtr node;
  double seam = 0.35; ///< mm on either side of its edge over which the colours mix.
};

/// A body with vessels or fat on its surface, which melt into it over `blend` mm.
class SurfaceVessels final : public ImplicitNode {
public:
  SurfaceVessels(NodePtr base, std::vector<SurfaceVessel> vessels, double blend);
  double distanceUpTo(const Vec3& point, double limit) const override;

private:
  Shade shadeUnfinished(const Vec3& point) const override;
  bool cannotMatter(const SurfaceVessel& vessel, const Vec3& point, double distance) const;

  NodePtr base_;
  std::vector<SurfaceVessel> vessels_;
  double blend_;
};

} // namespace viscera::sample_organs
