#pragma once

#include "implicit/implicit_node.h"

namespace viscera::sample_organs {

/// How `Displacement` roughens a surface.
struct Roughness {
  double amplitude = 1;   ///< mm, of the first octave.
  double wavelength = 20; ///< mm, of the first octave.
  int octaves = 1;        ///< Each with about half the amplitude and half the wavelength of the one before.
  int seed = 1;
};

/// The child with gentle bumps, so that it looks grown rather than turned on a lathe.
class Displacement final : public ImplicitNode {
public:
  Displacement(NodePtr child, const Roughness& roughness);
  double distanceUpTo(const Vec3& point, double limit) const override;

private:
  Shade shadeUnfinished(const Vec3& point) const override;
  double bump(const Vec3& point, double distance) const;

  NodePtr child_;
  Roughness roughness_;
};

} // namespace viscera::sample_organs
