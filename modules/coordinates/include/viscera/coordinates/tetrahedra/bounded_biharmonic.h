#pragma once

#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {

/// Bounded biharmonic weights of point handles (Jacobson et al. 2011, doi 10.1145/1964921.1964973): among all
/// weights in [0, 1] that add up to 1 and are 1 at their handle, those of least bilaplacian energy
/// `1/2 sum_i int (laplace w_i)^2`.
///
/// This is the joint problem, in which unity is a constraint on all handles together, and not the cheaper
/// variant that bounds each handle alone and normalises afterwards. The domain is the convex hull of the
/// handles, enlarged by `margin` percent about its middle, in tetrahedra whose edges are about a
/// `resolution`-th of its diagonal and which have the handles among their corners; the bilaplacian is
/// `K M^-1 K` with the lumped mass M. The weights keep bounds and unity exactly; how far they are from the
/// least energy is their residual, and the report has a note where that stays above 1e-4.
///
/// The weights do not reproduce a point: `p = sum w_i v_i` is false. A point moves by the weighted motions of
/// its handles, `p' = p + sum w_i (v'_i - v_i)`, so it follows translations but no other affine motion.
/// Weights are linear between the corners of the tetrahedra; derivatives are constant in each.
class BoundedBiharmonic final : public PointwiseSystem {
public:
  BoundedBiharmonic();
};

} // namespace viscera::coordinates
